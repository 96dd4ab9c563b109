#pragma once
#include <cmath>
#include <numbers>

#include "bins/outline.h"

/// Outlines that the tests of bins share.
namespace brewster::shapes {

inline void add_box(Outline& outline, glm::dvec2 low, glm::dvec2 high) {
    const glm::dvec2 a(high.x, low.y), b(low.x, high.y);
    outline.triangles.push_back({low, a, high});
    outline.triangles.push_back({low, high, b});
}

inline Outline rectangle(double width, double height) {
    Outline outline;
    outline.size = {width, height};
    add_box(outline, {0, 0}, {1, 1});
    return outline;
}

inline Outline right_triangle() {
    Outline outline;
    outline.triangles.push_back({glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)});
    return outline;
}

inline Outline l_shape() {
    Outline outline;
    add_box(outline, {0, 0}, {1, 0.3});
    add_box(outline, {0, 0.3}, {0.4, 1});
    return outline;
}

inline Outline annulus() {
    Outline outline;
    constexpr int sides = 24;
    const auto at = [](int i, double radius) {
        const double t = 2 * std::numbers::pi * i / sides;
        return glm::dvec2(0.5 + radius * std::cos(t), 0.5 + radius * std::sin(t));
    };
    for (int i = 0; i < sides; ++i) {
        outline.triangles.push_back({at(i, 0.3), at(i, 0.5), at(i + 1, 0.5)});
        outline.triangles.push_back({at(i, 0.3), at(i + 1, 0.5), at(i + 1, 0.3)});
    }
    return outline;
}

inline Outline wall_with_window() {
    Outline outline;
    outline.size = {4, 2.5};
    add_box(outline, {0, 0}, {1, 0.35});
    add_box(outline, {0, 0.8}, {1, 1});
    add_box(outline, {0, 0.35}, {0.3, 0.8});
    add_box(outline, {0.6, 0.35}, {1, 0.8});
    return outline;
}

}  // namespace brewster::shapes
