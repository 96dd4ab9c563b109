// text.frag
