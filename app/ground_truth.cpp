#include "app/ground_truth.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/seen_point.h"

namespace brewster {
namespace {

/// Malus for the Stokes vector: (S0 + S1 cos 2a + S2 sin 2a) / 2.
void add_polarizer_pictures(Image& picture) {
    constexpr std::array<int, 4> angles = {0, 45, 90, 135};
    constexpr std::array<float, 4> cosines = {1, 0, -1, 0}, sines = {0, 1, 0, -1};
    for (std::size_t k = 0; k < angles.size(); ++k) {
        for (int band = 0; band < 3; ++band) {
            std::vector<float> seen = picture.channel(stokes_channel(0, band));
            const std::vector<float>& s1 = picture.channel(stokes_channel(1, band));
            const std::vector<float>& s2 = picture.channel(stokes_channel(2, band));
            for (std::size_t i = 0; i < seen.size(); ++i)
                seen[i] = 0.5f * (seen[i] + cosines[k] * s1[i] + sines[k] * s2[i]);
            const char letter = band_letters[static_cast<std::size_t>(band)];
            picture.add_channel("I" + std::to_string(angles[k]) + "." + letter) = std::move(seen);
        }
    }
}

}  // namespace

void add_ground_truth(Image& picture, const Scene& scene, const Rays& rays, const Camera& camera) {
    add_polarizer_pictures(picture);
    const std::size_t pixels = picture.pixel_count();
    std::vector<float> depth(pixels), material(pixels, -1.0f);
    std::array<std::vector<float>, 3> normal, position;
    for (std::size_t k = 0; k < 3; ++k) {
        normal[k].resize(pixels);
        position[k].resize(pixels);
    }
    std::size_t i = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x, ++i) {
            const glm::vec3 direction = ray_direction(camera, picture.width(), picture.height(),
                                                      static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const std::optional<Hit> hit = seen_hit(rays, camera.position, direction);
            if (!hit) continue;
            const glm::dvec3 place = glm::dvec3(hit->position) + scene.centre;
            for (int k = 0; k < 3; ++k) {
                normal[static_cast<std::size_t>(k)][i] = hit->shading_normal[k];
                position[static_cast<std::size_t>(k)][i] = static_cast<float>(place[k]);
            }
            depth[i] = glm::dot(hit->position - camera.position, camera.forward);
            material[i] = static_cast<float>(scene.charts[hit->chart].material);
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const char axis = static_cast<char>('X' + static_cast<char>(k));
        picture.add_channel(std::string("N.") + axis) = std::move(normal[k]);
        picture.add_channel(std::string("P.") + axis) = std::move(position[k]);
    }
    picture.add_channel("Z") = std::move(depth);
    picture.add_channel("material") = std::move(material);
}

CameraMatrices camera_matrices(const Scene& scene, const Camera& camera, PictureSize size) {
    CameraMatrices matrices{};
    const double focal = 0.5 * size.height / std::tan(0.5 * static_cast<double>(camera.vertical_field_of_view));
    matrices.intrinsics[0][0] = matrices.intrinsics[1][1] = focal;
    matrices.intrinsics[0][2] = 0.5 * size.width;
    matrices.intrinsics[1][2] = 0.5 * size.height;
    matrices.intrinsics[2][2] = 1;
    const glm::dvec3 eye = glm::dvec3(camera.position) + scene.centre;
    const std::array<glm::dvec3, 3> axes = {glm::dvec3(camera.right()), -glm::dvec3(camera.up),
                                            glm::dvec3(camera.forward)};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            matrices.world_to_camera[row][column] = axes[static_cast<std::size_t>(row)][column];
            matrices.camera_to_world[column][row] = axes[static_cast<std::size_t>(row)][column];
        }
        matrices.world_to_camera[row][3] = -glm::dot(axes[static_cast<std::size_t>(row)], eye);
        matrices.camera_to_world[row][3] = eye[row];
    }
    matrices.world_to_camera[3][3] = matrices.camera_to_world[3][3] = 1;
    return matrices;
}

}  // namespace brewster
