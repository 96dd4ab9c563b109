// Light that leaves a chart towards the eye: its own, what comes back from its base, and, from the bins of gloss, what
// its interface sends on. A Stokes vector per band in the camera's frame, x = normalize(cross(ray, up)), as the receiver
// sees it.

#include "chart.glsl"

// What an interface lets out of the base: unpolarized and s minus p share, over the root of the cosine; three rows, one
// a band, for each material.
uniform sampler2D passages;
uniform vec3 camera_up;

layout(location = 0) out vec4 s0;        // cd/m2
layout(location = 1) out vec4 variance;  // of s0, by the leaves' standard errors
#ifdef BREWSTER_STOKES
layout(location = 2) out vec4 s1;
layout(location = 3) out vec4 s2;
layout(location = 4) out vec4 s3;
layout(location = 5) out vec4 variance_linear;  // of s1 and of s2, not less than either
layout(location = 6) out vec4 variance_s3;
#endif

// Cosine and sine of twice the angle from one axis to another about a direction; all unit, axes orthogonal to it.
vec2 turn_between(vec3 direction, vec3 from, vec3 to) {
    float c = dot(from, to), s = dot(direction, cross(from, to));
    return vec2((c - s) * (c + s), 2.0 * c * s) / max(c * c + s * s, 1e-12);
}

vec2 passage(float material, int band, float cosine) {
    float rows = float(textureSize(passages, 0).y);
    float columns = float(textureSize(passages, 0).x);
    float x = (0.5 + sqrt(clamp(cosine, 0.0, 1.0)) * (columns - 1.0)) / columns;
    return texture(passages, vec2(x, (3.0 * material + float(band) + 0.5) / rows)).xy;
}

// A small picture of what bins cannot show: light of the first surface that each of its rays has met, and that
// surface's chart. Its texels a fragment; 0: there is none.
uniform usampler2D glimpse_charts;
uniform sampler2D glimpse_s0;
uniform sampler2D glimpse_unpolarized;
#ifdef BREWSTER_STOKES
uniform sampler2D glimpse_s1;
uniform sampler2D glimpse_s2;
uniform sampler2D glimpse_s3;
#endif
uniform vec2 glimpse_scale;

#ifdef BREWSTER_STOKES
// Variance of a weighted mean's component from how far the rays' own lie from its share of their light. `squares`:
// weight^2 times component^2, component times light, light^2. One ray alone is known to within itself.
vec3 glimpse_variance(vec3 component, vec3 light, vec3 squares[3], float sum, int rays) {
    if (rays < 2) return component * component;
    vec3 share = component / max(light, vec3(1e-30));
    vec3 apart = squares[0] - 2.0 * share * squares[1] + share * share * squares[2];
    return max(apart, vec3(0.0)) / (sum * sum) * float(rays) / float(rays - 1);
}
#endif

// The light of the nearest texels whose rays have met this chart; false where none has. How bright it is, one ray knows to
// within its own light; how polarized, the rays beside it tell.
bool take_glimpse() {
    vec2 place = gl_FragCoord.xy * glimpse_scale - 0.5;
    ivec2 low = ivec2(floor(place)), last = textureSize(glimpse_charts, 0) - 1;
    vec2 part = place - vec2(low);
    float sum = 0.0;
    s0 = variance = vec4(0.0);
#ifdef BREWSTER_STOKES
    s1 = s2 = s3 = variance_linear = variance_s3 = vec4(0.0);
    vec3 squares_1[3], squares_2[3], squares_3[3];
    for (int k = 0; k < 3; ++k) squares_1[k] = squares_2[k] = squares_3[k] = vec3(0.0);
    int rays = 0;
#endif
    for (int k = 0; k < 4; ++k) {
        ivec2 step = ivec2(k & 1, k >> 1), at = clamp(low + step, ivec2(0), last);
        if (texelFetch(glimpse_charts, at, 0).x != chart_index) continue;
        vec2 share = mix(1.0 - part, part, vec2(step));
        float weight = share.x * share.y + 1e-4;
        sum += weight;
        if (unpolarized) {
            s0.rgb += weight * texelFetch(glimpse_unpolarized, at, 0).rgb;
        } else {
            vec3 light = weight * texelFetch(glimpse_s0, at, 0).rgb;
            s0.rgb += light;
#ifdef BREWSTER_STOKES
            vec3 one = weight * texelFetch(glimpse_s1, at, 0).rgb;
            vec3 two = weight * texelFetch(glimpse_s2, at, 0).rgb;
            vec3 three = weight * texelFetch(glimpse_s3, at, 0).rgb;
            s1.rgb += one;
            s2.rgb += two;
            s3.rgb += three;
            squares_1[0] += one * one;
            squares_1[1] += one * light;
            squares_2[0] += two * two;
            squares_2[1] += two * light;
            squares_3[0] += three * three;
            squares_3[1] += three * light;
            squares_1[2] += light * light;
            ++rays;
#endif
        }
    }
    if (sum == 0.0) return false;
    s0 = vec4(s0.rgb / sum, 1.0);
    variance = s0 * s0;
#ifdef BREWSTER_STOKES
    s1 /= sum;
    s2 /= sum;
    s3 /= sum;
    squares_2[2] = squares_3[2] = squares_1[2];
    variance_linear.rgb = max(glimpse_variance(s1.rgb, s0.rgb, squares_1, sum, rays),
                              glimpse_variance(s2.rgb, s0.rgb, squares_2, sum, rays));
    variance_s3.rgb = glimpse_variance(s3.rgb, s0.rgb, squares_3, sum, rays);
#endif
    return true;
}

void main() {
    uint first = chart_texels * chart_index;
    vec4 tint = color * texture(albedo_texture, texture_place);
    vec4 look = TEXEL(chart_materials, first + 2u);
    bool beyond_bins = TEXEL(chart_materials, first + 1u).w > 0.0, hole = look.z <= 1.0 && look.y * tint.a < look.z;
    if (glimpse_scale.x > 0.0 && beyond_bins && !hole && take_glimpse()) return;
    SeenBins seen = seen_bins(tint.a);
    vec3 albedo = TEXEL(chart_materials, first).rgb * mix(vec3(1.0), tint.rgb, look.x);
    vec3 inside = TEXEL(chart_materials, first + 3u).rgb;
    vec3 share = albedo / (vec3(1.0) - albedo * inside) * TEXEL(chart_materials, first + 4u).rgb;
    vec3 emission = TEXEL(chart_materials, first + 1u).rgb;

    float cosine = clamp(dot(seen.outwards, seen.normal), 0.0, 1.0);
    vec2 out_red = passage(look.w, 0, cosine), out_green = passage(look.w, 1, cosine);
    vec2 out_blue = passage(look.w, 2, cosine);
    vec3 out_share = share * vec3(out_red.x, out_green.x, out_blue.x);
    vec3 entered = seen.direct.value + seen.indirect.value;
    vec3 entered_variance = seen.direct.standard_error * seen.direct.standard_error +
                            seen.indirect.standard_error * seen.indirect.standard_error;
    s0 = vec4(emission + out_share * entered, 1.0);
    variance = vec4(out_share * out_share * entered_variance, 0.0);
    if (seen.has_gloss) {
        s0.rgb += seen.gloss.s0;
        variance.rgb += seen.gloss.standard_error * seen.gloss.standard_error;
    }
#ifdef BREWSTER_STOKES
    s1 = s2 = s3 = variance_linear = variance_s3 = vec4(0.0);
    vec3 camera_x = normalize(cross(-seen.outwards, camera_up));
    vec3 across = cross(seen.outwards, seen.normal);
    if (dot(across, across) > 1e-12) {
        vec2 turn = turn_between(seen.outwards, normalize(across), camera_x);
        vec3 polarized_share = share * vec3(out_red.y, out_green.y, out_blue.y);
        s1.rgb = turn.x * polarized_share * entered;
        s2.rgb = -turn.y * polarized_share * entered;
        variance_linear.rgb = polarized_share * polarized_share * entered_variance;
    }
    if (seen.has_gloss) {
        vec2 turn = turn_between(seen.outwards, seen.gloss_axis, camera_x);
        s1.rgb += turn.x * seen.gloss.s1 + turn.y * seen.gloss.s2;
        s2.rgb += turn.x * seen.gloss.s2 - turn.y * seen.gloss.s1;
        s3.rgb += seen.gloss.s3;
        variance_linear.rgb += seen.gloss.linear_error * seen.gloss.linear_error;
        variance_s3.rgb += seen.gloss.circular_error * seen.gloss.circular_error;
    }
#endif
}
