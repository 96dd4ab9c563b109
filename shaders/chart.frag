// chart.frag
