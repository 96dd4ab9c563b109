// Radiance that leaves a chart towards the eye: its own light, and what enters its Lambert base, reflected.

#include "bins.glsl"

// Three texels a chart: albedo; emission (cd/m2); whether the texture colours it (1 or 0), alpha, and the alpha below
// which a point is cut out.
uniform FLOAT_TEXELS chart_materials;
uniform sampler2D albedo_texture;  // linear; white where a chart has none

// Offsets of the world that is shown, in the leaves of the direct and of the indirect light.
uniform uvec2 shown_world;

in vec2 chart_coordinates;
flat in uint chart_index;
in vec2 texture_place;
in vec4 color;

layout(location = 0) out vec4 radiance;  // cd/m2
layout(location = 1) out vec4 variance;  // of the radiance, by the leaves' standard errors

const float pi = 3.14159265358979;

void main() {
    vec4 tint = color * texture(albedo_texture, texture_place);
    vec3 look = TEXEL(chart_materials, 3u * chart_index + 2u).rgb;
    if (look.y * tint.a < look.z) discard;
    uint u = fixed_point_of(chart_coordinates.x);
    uint v = fixed_point_of(chart_coordinates.y);
    uvec2 roots = TEXEL(chart_roots, chart_index).xy;
    BinValue direct = look_up(roots.x, shown_world.x, u, v);
    BinValue indirect = look_up(roots.y, shown_world.y, u, v);
    vec3 albedo = TEXEL(chart_materials, 3u * chart_index).rgb * mix(vec3(1.0), tint.rgb, look.x);
    vec3 reflected_share = albedo / pi;
    vec3 emission = TEXEL(chart_materials, 3u * chart_index + 1u).rgb;
    radiance = vec4(emission + reflected_share * (direct.value + indirect.value), 1.0);
    vec3 irradiance_variance = direct.standard_error * direct.standard_error +
                               indirect.standard_error * indirect.standard_error;
    variance = vec4(reflected_share * reflected_share * irradiance_variance, 0.0);
}
