// Rectangles in pixels from the upper left.

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 atlas;
layout(location = 2) in vec4 colour;

uniform vec2 screen_size;

out vec2 atlas_texel;
out vec4 ink;

void main() {
    gl_Position = vec4(2.0 * position.x / screen_size.x - 1.0, 1.0 - 2.0 * position.y / screen_size.y, 0.0, 1.0);
    atlas_texel = atlas;
    ink = colour;
}
