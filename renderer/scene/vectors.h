#pragma once
#include <glm/vec3.hpp>

#include "optics/vector.h"

namespace brewster {

/// Between the scene's coordinates and those of optics.
inline Vector<double> vector_of(const glm::vec3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Vector<double> double_vector(const Vector<float>& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Vector<float> single_vector(const Vector<double>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

inline Vector<float> float_vector(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

inline glm::vec3 glm_vector(const Vector<float>& v) {
    return {v.x, v.y, v.z};
}

inline glm::vec3 coordinates_of(const Vector<double>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace brewster
