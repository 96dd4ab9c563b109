// Directions of a hemisphere on the unit square, valid as C++ and GLSL: equal areas of the square are equal projected
// solid angles (theory 4). The direction's projection on the surface, a point of the unit disk, goes to the square by the
// inverse of the concentric map of Shirley and Chiu 1997: rings become squares, and no direction is singular.
// The includer provides BREWSTER_FUNCTION (inline, or nothing).

// atan on [-1, 1]: odd polynomial in its minimax form of degree 17, error below 2e-7.
BREWSTER_FUNCTION float atan_of_unit(float x) {
    float y = x * x;
    float p = 0.0028662257f;
    p = p * y - 0.0161657367f;
    p = p * y + 0.0429096138f;
    p = p * y - 0.0752896400f;
    p = p * y + 0.1065626393f;
    p = p * y - 0.1420889944f;
    p = p * y + 0.1999355085f;
    p = p * y - 0.3333314528f;
    return x + x * y * p;
}

// `projected`: the components of a unit direction along the two axes of the surface.
BREWSTER_FUNCTION vec2 direction_square(vec2 projected) {
    const float four_over_pi = 1.2732395447351628f;
    float x = projected.x, y = projected.y;
    float radius = min(sqrt(x * x + y * y), 1.0f);
    if (radius == 0.0f) return vec2(0.5f, 0.5f);
    vec2 centred;
    if (abs(x) >= abs(y)) {
        float signed_radius = x < 0.0f ? -radius : radius;
        centred = vec2(signed_radius, signed_radius * four_over_pi * atan_of_unit(y / x));
    } else {
        float signed_radius = y < 0.0f ? -radius : radius;
        centred = vec2(signed_radius * four_over_pi * atan_of_unit(x / y), signed_radius);
    }
    return vec2(0.5f + 0.5f * centred.x, 0.5f + 0.5f * centred.y);
}
