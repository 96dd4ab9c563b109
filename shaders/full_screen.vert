// full_screen.vert
