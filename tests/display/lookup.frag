// Evaluates the lookup at the points of a texture: (u, v, root), one a pixel.

#include "bins.glsl"

uniform sampler2D points;

layout(location = 0) out vec4 value;
layout(location = 1) out vec4 standard_error;
layout(location = 2) out vec4 place;

void main() {
    vec4 point = texelFetch(points, ivec2(gl_FragCoord.xy), 0);
    uint u = fixed_point_of(point.x);
    uint v = fixed_point_of(point.y);
    BinValue result = look_up(TEXEL(chart_roots, uint(point.z)).x, 0u, u, v);
    value = vec4(result.value, 0.0);
    standard_error = vec4(result.standard_error, 0.0);
    place = vec4(float(u), float(v), 0.0, 0.0);
}
