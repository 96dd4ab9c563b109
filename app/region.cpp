#include "app/region.h"

#include "app/seen_point.h"
#include "scene/rays.h"

namespace brewster {
std::vector<std::uint8_t> region_mask(const Scene& scene, const std::string& camera_name,
                                      const std::vector<std::string>& meshes, int width, int height) {
    const Camera& camera = scene.camera(camera_name);
    std::vector<std::uint8_t> wanted(scene.charts.size(), 0);
    for (const std::string& mesh : meshes)
        for (const std::uint32_t chart : scene.charts_of(mesh)) wanted[chart] = 1;

    const Rays rays(scene);
    const auto shows_mesh = [&](float x, float y) {
        const std::optional<Hit> hit = seen_hit(rays, camera.position, ray_direction(camera, width, height, x, y));
        return hit && wanted[hit->chart];
    };
    // Corners are shared by four pixels: asked once.
    const std::size_t columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    std::vector<std::uint8_t> corners((columns + 1) * (rows + 1)), mask(columns * rows);
    for (std::size_t y = 0; y <= rows; ++y)
        for (std::size_t x = 0; x <= columns; ++x)
            corners[y * (columns + 1) + x] = shows_mesh(static_cast<float>(x), static_cast<float>(y));
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x) {
            const std::uint8_t* corner = &corners[y * (columns + 1) + x];
            mask[y * columns + x] = corner[0] && corner[1] && corner[columns + 1] && corner[columns + 2] &&
                                    shows_mesh(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        }
    return mask;
}

}  // namespace brewster
