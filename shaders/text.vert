// text.vert
