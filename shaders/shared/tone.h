// From radiance to the screen, valid as C++ and GLSL. The includer provides BREWSTER_FUNCTION (inline, or nothing).
//
// Exposure: radiance in cd/m2 times 2^EV. The greatest of the three bands decides how far the curve bends them:
//   up to the knee k = 0.25 the screen is linear in the radiance, so darks keep their contrast;
//   above, 1 - (1 - k) / (1 + t) with t = (x - k) / (1 - k): the same slope at the knee, white only as the limit,
//   and still apart where an exponential would be white: 10 times the knee gives 0.81, 100 times 0.98.
// The other bands keep their ratio to the greatest one, so hues stay, but a share s^4 of the difference is filled up
// with white, s = t / (1 + t): the very bright turns white instead of a flat patch of colour.

#define BREWSTER_TONE_KNEE 0.25f

// The curve alone: [0, infinity) -> [0, 1).
BREWSTER_FUNCTION float shoulder(float x) {
    float t = max(x - BREWSTER_TONE_KNEE, 0.0f) / (1.0f - BREWSTER_TONE_KNEE);
    return min(x, BREWSTER_TONE_KNEE) + (1.0f - BREWSTER_TONE_KNEE) * (t / (1.0f + t));
}

// Exposed linear colour (not negative) -> linear light of the screen, each band in [0, 1).
BREWSTER_FUNCTION vec3 tone_mapped(vec3 exposed) {
    float greatest = max(max(exposed.x, exposed.y), exposed.z);
    if (greatest <= 0.0f) return vec3(0.0f);
    float level = shoulder(greatest);
    float s = max(level - BREWSTER_TONE_KNEE, 0.0f) / (1.0f - BREWSTER_TONE_KNEE);
    float white = s * s * s * s;
    return level * (exposed / greatest * (1.0f - white) + vec3(white));
}

// IEC 61966-2-1: linear light in [0, 1] -> sRGB code in [0, 1].
BREWSTER_FUNCTION float srgb_code(float linear_light) {
    return linear_light <= 0.0031308f ? 12.92f * linear_light : 1.055f * pow(linear_light, 1.0f / 2.4f) - 0.055f;
}

// Radiance in cd/m2 at an exposure in EV -> sRGB code.
BREWSTER_FUNCTION vec3 screen_colour(vec3 radiance, float exposure) {
    vec3 light = tone_mapped(max(radiance, vec3(0.0f)) * exp2(exposure));
    return vec3(srgb_code(light.x), srgb_code(light.y), srgb_code(light.z));
}
