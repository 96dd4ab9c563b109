// chart.vert
