// Light that leaves a chart towards the eye: its own, what comes back from its base, and, from the bins of gloss, what
// its interface sends on. A Stokes vector per band in the camera's frame, x = normalize(cross(ray, up)), as the receiver
// sees it.

#include "bins.glsl"

// Seven texels a chart: albedo of the base; emission (cd/m2); whether the texture colours it (1 or 0), alpha, the alpha
// below which a point is cut out, and its material; reflectance of the interface from inside; what the base sends back
// for each unit that enters, by albedo 1 and no interface from inside (1/sr); the chart's axes.
uniform FLOAT_TEXELS chart_materials;
const uint chart_texels = 7u;
uniform sampler2D albedo_texture;  // linear; white where a chart has none
// What an interface lets out of the base: unpolarized and s minus p share, over the root of the cosine; three rows, one
// a band, for each material.
uniform sampler2D passages;

// Offsets of the world that is shown, in the leaves of the direct and of the indirect light.
uniform uvec2 shown_world;
uniform bool unpolarized;     // the world that is shown is the one without polarization
uniform int gloss_components;  // of the bins' Stokes vectors
uniform vec3 eye, camera_up;

in vec2 chart_coordinates;
flat in uint chart_index;
in vec2 texture_place;
in vec4 color;
in vec3 seen_point;
in vec3 seen_normal;

layout(location = 0) out vec4 s0;        // cd/m2
layout(location = 1) out vec4 variance;  // of s0, by the leaves' standard errors
#ifdef BREWSTER_STOKES
layout(location = 2) out vec4 s1;
layout(location = 3) out vec4 s2;
layout(location = 4) out vec4 s3;
#endif

// Cosine and sine of twice the angle from one axis to another about a direction; all unit, axes orthogonal to it.
vec2 turn_between(vec3 direction, vec3 from, vec3 to) {
    float c = dot(from, to), s = dot(direction, cross(from, to));
    return vec2((c - s) * (c + s), 2.0 * c * s) / max(c * c + s * s, 1e-12);
}

// theory 4: the tangent carried from the normal to the direction.
vec3 transported_axis(vec3 normal, vec3 tangent, vec3 direction) {
    return tangent - dot(tangent, direction) / (1.0 + dot(normal, direction)) * (normal + direction);
}

vec2 passage(float material, int band, float cosine) {
    float rows = float(textureSize(passages, 0).y);
    float columns = float(textureSize(passages, 0).x);
    float x = (0.5 + sqrt(clamp(cosine, 0.0, 1.0)) * (columns - 1.0)) / columns;
    return texture(passages, vec2(x, (3.0 * material + float(band) + 0.5) / rows)).xy;
}

void main() {
    uint first = chart_texels * chart_index;
    vec4 tint = color * texture(albedo_texture, texture_place);
    vec4 look = TEXEL(chart_materials, first + 2u);
    if (look.y * tint.a < look.z) discard;
    uint u = fixed_point_of(chart_coordinates.x);
    uint v = fixed_point_of(chart_coordinates.y);
    uvec2 roots = TEXEL(chart_roots, 2u * chart_index).xy;
    BinValue direct = look_up(roots.x, shown_world.x, u, v);
    BinValue indirect = look_up(roots.y, shown_world.y, u, v);
    vec3 albedo = TEXEL(chart_materials, first).rgb * mix(vec3(1.0), tint.rgb, look.x);
    vec3 inside = TEXEL(chart_materials, first + 3u).rgb;
    vec3 share = albedo / (vec3(1.0) - albedo * inside) * TEXEL(chart_materials, first + 4u).rgb;
    vec3 axis_u = TEXEL(chart_materials, first + 5u).xyz, axis_v = TEXEL(chart_materials, first + 6u).xyz;
    vec3 mean_normal = cross(axis_u, axis_v);

    vec3 outwards = normalize(eye - seen_point);
    vec3 normal = normalize(seen_normal);
    float cosine = clamp(dot(outwards, normal), 0.0, 1.0);
    vec2 out_red = passage(look.w, 0, cosine), out_green = passage(look.w, 1, cosine);
    vec2 out_blue = passage(look.w, 2, cosine);
    vec3 base = share * (direct.value + indirect.value);
    vec3 emission = TEXEL(chart_materials, first + 1u).rgb;
    vec3 out_share = vec3(out_red.x, out_green.x, out_blue.x);
    s0 = vec4(emission + base * out_share, 1.0);
    vec3 base_variance = share * out_share;
    base_variance *= base_variance;
    variance = vec4(base_variance * (direct.standard_error * direct.standard_error +
                                     indirect.standard_error * indirect.standard_error), 0.0);

    vec3 tangent_u = transported_axis(mean_normal, axis_u, normal);
    vec3 tangent_v = transported_axis(mean_normal, axis_v, normal);
    uint gloss_root = TEXEL(chart_roots, 2u * chart_index + 1u).x;
    bool has_gloss = gloss_root != 0xffffffffu && dot(outwards, normal) > 0.0;
    GlossValue gloss;
    if (has_gloss) {
        vec2 square = direction_square(vec2(dot(outwards, tangent_u), dot(outwards, tangent_v)));
        gloss = look_up_gloss(gloss_root, gloss_components, unpolarized, u, v, fixed_point_of(square.x),
                              fixed_point_of(square.y));
        s0.rgb += gloss.s0;
        variance.rgb += gloss.standard_error * gloss.standard_error;
    }
#ifdef BREWSTER_STOKES
    s1 = s2 = s3 = vec4(0.0);
    if (unpolarized) return;
    vec3 camera_x = normalize(cross(-outwards, camera_up));
    vec3 across = cross(outwards, normal);
    if (dot(across, across) > 1e-12) {
        vec2 turn = turn_between(outwards, normalize(across), camera_x);
        vec3 polarized = base * vec3(out_red.y, out_green.y, out_blue.y);
        s1.rgb = turn.x * polarized;
        s2.rgb = -turn.y * polarized;
    }
    if (has_gloss) {
        vec2 turn = turn_between(outwards, transported_axis(normal, tangent_u, outwards), camera_x);
        s1.rgb += turn.x * gloss.s1 + turn.y * gloss.s2;
        s2.rgb += turn.x * gloss.s2 - turn.y * gloss.s1;
        s3.rgb += gloss.s3;
    }
#endif
}
