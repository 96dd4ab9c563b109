// Linear light as the screen shows it: behind an analyzer, as a map, exposed. The light comes as means times a
// number of draws, the alpha of S0: draws of the bins, or 1 from rays of the eye. A program for each way of looking, since a processor that draws would
// work out every branch: BREWSTER_MAP is the map; BREWSTER_ANALYZER: there is an analyzer; BREWSTER_STRETCHED: the
// picture is not as large as the screen.

#include "maps.glsl"

uniform sampler2D light_s0, light_s1, light_s2, light_s3;
uniform sampler2D light_unpolarized;
uniform sampler2D variance_s0, variance_linear, variance_s3;
uniform sampler2D squares_s0;  // sum over the draws of the square of S0
uniform bool has_squares;
uniform bool over;  // another picture: it stays where there are no draws
const int map = BREWSTER_MAP;
uniform int palette;
uniform float exposure;  // EV
#ifdef BREWSTER_ANALYZER
uniform vec4 analyzer;  // see analysed in shared/stokes.h
#endif
#ifdef BREWSTER_STRETCHED
uniform vec2 screen_size;  // pixels
#endif

out vec4 colour;

// Between pixels only where the picture is stretched: a filter of eight bits lets a bright neighbour in even at a centre.
vec4 texel(sampler2D picture) {
#ifdef BREWSTER_STRETCHED
    return texture(picture, gl_FragCoord.xy / screen_size);
#else
    return texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
#endif
}

vec3 sampled(sampler2D picture) {
    return texel(picture).rgb;
}

void main() {
    PixelLight light;
    vec4 s0 = texel(light_s0);
    if (over && s0.a == 0.0) discard;
    float draws = max(s0.a, 1.0);  // 0 where there is no light
    light.s0 = s0.rgb / draws;
    light.s1 = light.s2 = light.s3 = light.unpolarized = vec3(0.0);
    light.error_s0 = light.error_linear = light.error_s3 = vec3(0.0);
    if (map != map_bins) {  // what the map does not look at, the compiler leaves out
        light.s1 = sampled(light_s1) / draws;
        light.s2 = sampled(light_s2) / draws;
        light.s3 = sampled(light_s3) / draws;
        vec4 unpolarized = texel(light_unpolarized);
        light.unpolarized = unpolarized.rgb / max(unpolarized.a, 1.0);
        vec3 variance = sampled(variance_s0) / draws;
        if (has_squares && draws > 1.0) {
            vec3 spread = sampled(squares_s0) / draws - light.s0 * light.s0;
            variance += max(spread, vec3(0.0)) / (draws - 1.0);
        }
        light.error_s0 = sqrt(variance);
        light.error_linear = sqrt(sampled(variance_linear) / draws);
        light.error_s3 = sqrt(sampled(variance_s3) / draws);
#ifdef BREWSTER_ANALYZER
        light = behind(analyzer, light);
#endif
    }
    colour = vec4(map_colour(map, light, exposure, palette), 1.0);
}
