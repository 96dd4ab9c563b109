// What the fragment shaders of charts have in common: where on which chart the eye looks, and what the bins hold there.

#include "bins.glsl"

// Seven texels a chart: albedo of the base; emission (cd/m2) and whether bins
// are too coarse for it; whether the texture colours it (1 or 0), alpha, the alpha
// below which a point is cut out, and its material; reflectance of the interface from inside; what the base sends back
// for each unit that enters, by albedo 1 and no interface from inside (1/sr); the chart's axes.
uniform FLOAT_TEXELS chart_materials;
const uint chart_texels = 7u;
uniform sampler2D albedo_texture;  // linear; white where a chart has none

// Offsets of the world that is shown, in the leaves of the direct and of the indirect light.
uniform uvec2 shown_world;
uniform bool unpolarized;      // the world that is shown is the one without polarization
uniform int gloss_components;  // of the bins' Stokes vectors
uniform vec3 eye;
uniform bool flat_light;  // for measuring what looking into the bins costs: they say 1 everywhere

in vec2 chart_coordinates;
flat in uint chart_index;
in vec2 texture_place;
in vec4 color;
in vec3 seen_point;
in vec3 seen_normal;

// theory 4: the tangent carried from the normal to the direction.
vec3 transported_axis(vec3 normal, vec3 tangent, vec3 direction) {
    return tangent - dot(tangent, direction) / (1.0 + dot(normal, direction)) * (normal + direction);
}

struct SeenBins {
    BinValue direct, indirect;
    bool has_gloss;
    GlossValue gloss;
    vec3 outwards, normal;  // towards the eye; of the surface that the mesh stands for
    vec3 gloss_axis;        // x axis of the Stokes vectors of gloss
};

// Leaves out what is cut out of the chart.
SeenBins seen_bins(float alpha) {
    vec4 look = TEXEL(chart_materials, chart_texels * chart_index + 2u);
    if (look.y * alpha < look.z) discard;
    uint u = fixed_point_of(chart_coordinates.x);
    uint v = fixed_point_of(chart_coordinates.y);
    uvec2 roots = TEXEL(chart_roots, 2u * chart_index).xy;
    SeenBins seen;
    if (flat_light) {
        seen.direct = seen.indirect = BinValue(vec3(1.0), vec3(0.0), 0u);
    } else {
        seen.direct = look_up(roots.x, shown_world.x, u, v);
        seen.indirect = look_up(roots.y, shown_world.y, u, v);
    }
    seen.outwards = normalize(eye - seen_point);
    seen.normal = normalize(seen_normal);
    uint gloss_root = TEXEL(chart_roots, 2u * chart_index + 1u).x;
    seen.has_gloss = !flat_light && gloss_root != 0xffffffffu && dot(seen.outwards, seen.normal) > 0.0;
    if (seen.has_gloss) {
        vec3 axis_u = TEXEL(chart_materials, chart_texels * chart_index + 5u).xyz;
        vec3 axis_v = TEXEL(chart_materials, chart_texels * chart_index + 6u).xyz;
        vec3 mean_normal = cross(axis_u, axis_v);
        vec3 tangent_u = transported_axis(mean_normal, axis_u, seen.normal);
        vec3 tangent_v = transported_axis(mean_normal, axis_v, seen.normal);
        vec2 square = direction_square(vec2(dot(seen.outwards, tangent_u), dot(seen.outwards, tangent_v)));
        seen.gloss = look_up_gloss(gloss_root, gloss_components, unpolarized, u, v, fixed_point_of(square.x),
                                   fixed_point_of(square.y));
        seen.gloss_axis = transported_axis(seen.normal, tangent_u, seen.outwards);
    }
    return seen;
}
