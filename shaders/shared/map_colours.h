// The colours of the maps, as sRGB codes in [0, 1]: the one place where they are written down, valid as C++ and GLSL.
// The includer provides BREWSTER_FUNCTION (inline, or nothing).
//
// Palettes:
//   blue-orange  safe for all kinds of colour blindness: signs differ along blue and yellow, degrees rise in lightness,
//                angles that differ by 90 degrees differ in lightness or along blue and yellow. Own definition.
//   red-green    signs as in Mitsuba 3 (src/integrators/stokes.cpp: green positive, red negative, black zero); degree
//                red, type cyan (linear) to yellow (circular) as in A. Wilkie, A. Weidlich, "A standardised polarisation
//                visualisation for images", SCCG 2010; left circular, which they keep for a picture of its own, magenta.
//   polanalyser  signs blue, white, red; angle by hue (S. Baek et al., SIGGRAPH 2020); degree and type as red-green:
//                the colours of the Python library polanalyser (elerac/polanalyser, README).
// In all of them the hue of an angle is twice the angle: red is horizontal, cyan vertical.

#define BREWSTER_BLUE_ORANGE 0
#define BREWSTER_RED_GREEN 1
#define BREWSTER_POLANALYSER 2

// Where a map has nothing to say: no light, or none that is polarized beyond its noise.
BREWSTER_FUNCTION vec3 masked_colour() {
    return vec3(0.14f);
}

// `level` in [-1, 1].
BREWSTER_FUNCTION vec3 signed_colour(int palette, float level) {
    float t = min(abs(level), 1.0f);
    if (palette == BREWSTER_RED_GREEN) return level > 0.0f ? vec3(0.0f, t, 0.0f) : vec3(t, 0.0f, 0.0f);
    if (palette == BREWSTER_POLANALYSER) {
        return level > 0.0f ? vec3(1.0f, 1.0f - t, 1.0f - t) : vec3(1.0f - t, 1.0f - t, 1.0f);
    }
    return level > 0.0f ? t * vec3(1.0f, 0.62f, 0.12f) : t * vec3(0.25f, 0.63f, 1.0f);
}

// `level` in [0, 1].
BREWSTER_FUNCTION vec3 degree_colour(int palette, float level) {
    float t = clamp(level, 0.0f, 1.0f);
    if (palette != BREWSTER_BLUE_ORANGE) return vec3(t, 0.0f, 0.0f);
    vec3 night = vec3(0.0f, 0.0f, 0.0f), blue = vec3(0.10f, 0.24f, 0.60f), dusk = vec3(0.52f, 0.42f, 0.56f);
    vec3 orange = vec3(0.95f, 0.58f, 0.20f), pale = vec3(1.0f, 0.96f, 0.78f);
    if (t < 0.25f) return mix(night, blue, 4.0f * t);
    if (t < 0.5f) return mix(blue, dusk, 4.0f * t - 1.0f);
    if (t < 0.75f) return mix(dusk, orange, 4.0f * t - 2.0f);
    return mix(orange, pale, 4.0f * t - 3.0f);
}

// The pure colour of a hue in turns, 0 red, 1/3 green, 2/3 blue.
BREWSTER_FUNCTION vec3 hue_colour(float hue) {
    float h = 6.0f * fract(hue);
    return vec3(clamp(abs(h - 3.0f) - 1.0f, 0.0f, 1.0f), clamp(2.0f - abs(h - 2.0f), 0.0f, 1.0f),
                clamp(2.0f - abs(h - 4.0f), 0.0f, 1.0f));
}

// `half_turns`: AoLP / 180 degrees. Blue-orange lightens the hues around 150 degrees and darkens their opposites: to the
// colour-blind these two look alike otherwise. White and black leave the hue what it is.
BREWSTER_FUNCTION vec3 angle_colour(int palette, float half_turns) {
    vec3 colour = hue_colour(half_turns);
    if (palette != BREWSTER_BLUE_ORANGE) return colour;
    const float two_pi = 6.2831853071795865f;
    float lightness = cos(two_pi * (half_turns - 150.0f / 360.0f));
    return mix(colour, lightness > 0.0f ? vec3(1.0f) : vec3(0.0f), 0.5f * abs(lightness));
}

// `roundness` from -1, left circular, by 0, linear, to 1, right circular; `strength` in [0, 1].
BREWSTER_FUNCTION vec3 type_colour(int palette, float roundness, float strength) {
    vec3 flat_colour = vec3(0.0f, 1.0f, 1.0f), right = vec3(1.0f, 1.0f, 0.0f), left = vec3(1.0f, 0.0f, 1.0f);
    if (palette == BREWSTER_BLUE_ORANGE) {
        flat_colour = vec3(0.92f, 0.92f, 0.92f);
        right = vec3(1.0f, 0.58f, 0.05f);
        left = vec3(0.15f, 0.50f, 1.0f);
    }
    return strength * mix(flat_colour, roundness > 0.0f ? right : left, min(abs(roundness), 1.0f));
}

// A colour for a number, so that neighbours differ: the lowest bits of a multiplicative hash.
BREWSTER_FUNCTION vec3 cell_colour(uint number) {
    uint h = number * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    h = (h >> 22u) ^ h;
    vec3 random = vec3(float(h & 255u), float((h >> 8u) & 255u), float((h >> 16u) & 255u)) / 255.0f;
    return vec3(0.15f) + 0.75f * random;
}
