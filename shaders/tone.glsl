// tone.glsl
