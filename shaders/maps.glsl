// What a map makes of the light of a pixel. The numbers of the maps are those of enum class Map (display/maps.h).

#include "shared/tone.h"
#include "shared/stokes.h"
#include "shared/map_colours.h"

const int map_radiance = 0, map_s1 = 1, map_s2 = 2, map_s3 = 3, map_dop = 4, map_dolp = 5, map_aolp = 6, map_docp = 7;
const int map_type = 8, map_difference = 9, map_error = 10, map_bins = 11;

// Light of a pixel, by band: four components and the radiance of the world where no surface tells polarizations apart;
// standard errors of S0, of S1 and S2, of S3.
struct PixelLight {
    vec3 s0, s1, s2, s3, unpolarized;
    vec3 error_s0, error_linear, error_s3;
};

float band_mean(vec3 bands) { return (bands.x + bands.y + bands.z) / 3.0; }

// The light that passes the analyzer, each band by itself.
PixelLight behind(vec4 analyzer, PixelLight light) {
    for (int band = 0; band < 3; ++band) {
        vec4 passed =
            analysed(vec4(light.s0[band], light.s1[band], light.s2[band], light.s3[band]), analyzer);
        light.s0[band] = passed.x;
        light.s1[band] = passed.y;
        light.s2[band] = passed.z;
        light.s3[band] = passed.w;
        vec3 errors = vec3(light.error_s0[band], light.error_linear[band], light.error_s3[band]);
        vec3 noise = analysed_noise(errors * errors, analyzer);
        light.error_s0[band] = sqrt(noise.x);
        light.error_linear[band] = sqrt(noise.y);
        light.error_s3[band] = sqrt(noise.z);
    }
    light.unpolarized *= 0.5;
    return light;
}

// Signed radiance in cd/m2: as bright as the tone curve shows that much light.
float signed_level(float radiance, float exposure) {
    float level = srgb_code(shoulder(abs(radiance) * exp2(exposure)));
    return radiance < 0.0 ? -level : level;
}

// sRGB code. Maps other than the radiance look at band means. Bands of one path share its luck, so that their errors
// add up as if they were one.
vec3 map_colour(int map, PixelLight light, float exposure, int palette) {
    if (map == map_radiance) return screen_colour(light.s0, exposure);
    if (map == map_bins) return light.s0;
    vec4 stokes = vec4(band_mean(light.s0), band_mean(light.s1), band_mean(light.s2), band_mean(light.s3));
    vec3 errors = vec3(band_mean(light.error_s0), band_mean(light.error_linear), band_mean(light.error_s3));
    vec3 noise = errors * errors;
    if (map == map_s1) return signed_colour(palette, signed_level(stokes.y, exposure));
    if (map == map_s2) return signed_colour(palette, signed_level(stokes.z, exposure));
    if (map == map_s3) return signed_colour(palette, signed_level(stokes.w, exposure));
    if (map == map_difference) {
        return signed_colour(palette, signed_level(stokes.x - band_mean(light.unpolarized), exposure));
    }
    if (map == map_error) {
        float level = error_level(stokes.x, noise.x);
        return level < 0.0 ? masked_colour() : degree_colour(palette, level);
    }
    if (map == map_dolp) return degree_colour(palette, linear_degree(stokes, noise));
    if (map == map_docp) return degree_colour(palette, circular_degree(stokes, noise));
    if (map == map_aolp) {
        if (linear_degree(stokes, noise) <= 0.0) return masked_colour();
        return angle_colour(palette, half_turns(stokes));
    }
    float degree = polarization_degree(stokes, noise);
    if (map == map_dop) return degree_colour(palette, degree);
    if (degree <= 0.0) return masked_colour();
    return type_colour(palette, roundness(stokes), srgb_code(degree));
}
