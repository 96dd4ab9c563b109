// Glyphs by their coverage in the atlas; a negative place in it is covered all over.

uniform sampler2D glyphs;

in vec2 atlas_texel;
in vec4 ink;

out vec4 colour;

void main() {
    float coverage = atlas_texel.x < 0.0 ? 1.0 : texelFetch(glyphs, ivec2(atlas_texel), 0).r;
    colour = vec4(ink.rgb, ink.a * coverage);
}
