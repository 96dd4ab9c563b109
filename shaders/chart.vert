// Corners of the charts' triangles, each with its place on the chart.

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 unit_coordinates;
layout(location = 2) in uint chart;
layout(location = 3) in vec2 texture_coordinates;
layout(location = 4) in vec4 vertex_color;  // linear, times the texture

uniform mat4 view_projection;

out vec2 chart_coordinates;
flat out uint chart_index;
out vec2 texture_place;
out vec4 color;

void main() {
    gl_Position = view_projection * vec4(position, 1.0);
    chart_coordinates = unit_coordinates;
    chart_index = chart;
    texture_place = texture_coordinates;
    color = vertex_color;
}
