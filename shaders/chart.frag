// Radiance that leaves a chart towards the eye: its own light, and what enters its Lambert base, reflected.

#include "bins.glsl"

// Two texels a chart: albedo, emission (cd/m2).
uniform FLOAT_TEXELS chart_materials;

// Offsets of the world that is shown, in the leaves of the direct and of the indirect light.
uniform uvec2 shown_world;

in vec2 chart_coordinates;
flat in uint chart_index;

layout(location = 0) out vec4 radiance;  // cd/m2
layout(location = 1) out vec4 variance;  // of the radiance, by the leaves' standard errors

const float pi = 3.14159265358979;

void main() {
    uint u = fixed_point_of(chart_coordinates.x);
    uint v = fixed_point_of(chart_coordinates.y);
    uvec2 roots = TEXEL(chart_roots, chart_index).xy;
    BinValue direct = look_up(roots.x, shown_world.x, u, v);
    BinValue indirect = look_up(roots.y, shown_world.y, u, v);
    vec3 reflected_share = TEXEL(chart_materials, 2u * chart_index).rgb / pi;
    vec3 emission = TEXEL(chart_materials, 2u * chart_index + 1u).rgb;
    radiance = vec4(emission + reflected_share * (direct.value + indirect.value), 1.0);
    vec3 irradiance_variance = direct.standard_error * direct.standard_error +
                               indirect.standard_error * indirect.standard_error;
    variance = vec4(reflected_share * reflected_share * irradiance_variance, 0.0);
}
