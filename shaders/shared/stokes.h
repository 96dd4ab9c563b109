// What a Stokes vector says, valid as C++ and GLSL: an analyzer in front of the camera, degrees, angle and type of
// polarization, and what of them is more than noise. renderer/optics is the oracle. The includer provides
// BREWSTER_FUNCTION (inline, or nothing).
//
// Vectors hold S0, S1, S2, S3 as the receiver sees them: x to the right, y up, S3 > 0 right circular. Noise holds the
// variances of S0, of S1 and S2 (the larger one), of S3, in its first three places.

// Light counts as polarized from so many standard errors on. A component that is pure noise passes 4 of them once in
// 16000 times, the length of two once in 3000, of three once in 800.
#define BREWSTER_NOISE_FLOOR 4.0f

// What passes an ideal analyzer. Its x, y, z are the normalized S1, S2, S3 of the light it lets through whole
// ((cos 2a, sin 2a, 0) for a polarizer that passes at the angle a, (0, 0, +-1) for a circular one); w is 1, or 0 where
// there is none. Its Mueller matrix is 1/2 (1, a)(1, a)^T (theory 1.3).
BREWSTER_FUNCTION vec4 analysed(vec4 stokes, vec4 analyzer) {
    if (analyzer.w == 0.0f) return stokes;
    float passed = 0.5f * (stokes.x + analyzer.x * stokes.y + analyzer.y * stokes.z + analyzer.z * stokes.w);
    return vec4(passed, passed * analyzer.x, passed * analyzer.y, passed * analyzer.z);
}

// Noise behind the analyzer, at most: as if the errors of S0 and of what is added to it had one sign.
BREWSTER_FUNCTION vec3 analysed_noise(vec3 noise, vec4 analyzer) {
    if (analyzer.w == 0.0f) return noise;
    float linear_error = sqrt(noise.y) * sqrt(analyzer.x * analyzer.x + analyzer.y * analyzer.y);
    float error = 0.5f * (sqrt(noise.x) + linear_error + sqrt(noise.z) * abs(analyzer.z));
    return vec3(error * error);
}

// sqrt of a squared length less its share of noise, over S0; 0 where the square is no more than noise can make, and in
// the dark. `floor_variance`: of the noisiest component; `noise`: the sum over components, which the square holds on
// average beside the truth. At most 1.
BREWSTER_FUNCTION float degree_above_noise(float square, float noise, float floor_variance, float s0) {
    float least = BREWSTER_NOISE_FLOOR * BREWSTER_NOISE_FLOOR * floor_variance;
    if (square <= least || s0 <= 0.0f) return 0.0f;
    return min(sqrt(max(square - noise, 0.0f)) / s0, 1.0f);
}

BREWSTER_FUNCTION float linear_degree(vec4 stokes, vec3 noise) {
    return degree_above_noise(stokes.y * stokes.y + stokes.z * stokes.z, 2.0f * noise.y, noise.y, stokes.x);
}

BREWSTER_FUNCTION float circular_degree(vec4 stokes, vec3 noise) {
    return degree_above_noise(stokes.w * stokes.w, noise.z, noise.z, stokes.x);
}

BREWSTER_FUNCTION float polarization_degree(vec4 stokes, vec3 noise) {
    float square = stokes.y * stokes.y + stokes.z * stokes.z + stokes.w * stokes.w;
    return degree_above_noise(square, 2.0f * noise.y + noise.z, max(noise.y, noise.z), stokes.x);
}

// Angle of linear polarization over the half circle: AoLP / 180 degrees in [0, 1), counter-clockwise from the right.
BREWSTER_FUNCTION float half_turns(vec4 stokes) {
    const float half_over_pi = 0.15915494309189535f;
    return fract(half_over_pi * atan(stokes.z, stokes.y));
}

// From left circular, -1, by linear, 0, to right circular, 1: the sine of twice the ellipticity angle.
BREWSTER_FUNCTION float roundness(vec4 stokes) {
    float square = stokes.y * stokes.y + stokes.z * stokes.z + stokes.w * stokes.w;
    return square > 0.0f ? stokes.w / sqrt(square) : 0.0f;
}

// Standard error of S0 relative to it, on a scale from 0 (0.1 % and less) to 1 (100 % and more), by its logarithm;
// negative in the dark.
BREWSTER_FUNCTION float error_level(float s0, float variance) {
    if (s0 <= 0.0f) return -1.0f;
    const float decades = 3.0f, log10_of_2 = 0.30102999566398120f;
    float relative = sqrt(variance) / s0;
    if (relative <= 0.0f) return 0.0f;
    return clamp(1.0f + log10_of_2 * log2(relative) / decades, 0.0f, 1.0f);
}
