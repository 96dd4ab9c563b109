#include "scene/scene_hash.h"

#include <bit>
#include <cstring>

#include "base/digest.h"

namespace brewster {
namespace {

class SceneHash {
  public:
    void add(std::uint64_t word) { digest_.add(word); }
    void add(float number) { add(std::uint64_t{std::bit_cast<std::uint32_t>(number)}); }
    void add(const glm::vec2& v) {
        for (int i = 0; i < 2; ++i) add(v[i]);
    }
    void add(const glm::vec3& v) {
        for (int i = 0; i < 3; ++i) add(v[i]);
    }
    void add(const glm::vec4& v) {
        for (int i = 0; i < 4; ++i) add(v[i]);
    }
    void add(const Triangle& triangle) {
        for (const std::uint32_t vertex : triangle.vertices) add(std::uint64_t{vertex});
        for (const std::uint32_t index : {triangle.front_chart, triangle.back_chart, triangle.surface})
            add(std::uint64_t{index});
    }
    void add(const Chart& chart) {
        for (const std::uint32_t index : {chart.material, chart.surface, chart.first_triangle, chart.triangle_count})
            add(std::uint64_t{index});
        for (const glm::vec3& v :
             {chart.origin, chart.axis_u, chart.axis_v, chart.normal, chart.sheet_x, chart.sheet_y})
            add(v);
        add(chart.size_u);
        add(chart.size_v);
        add(std::uint64_t{chart.curved});
    }
    void add(const Material& material) {
        const Interface& interface = material.interface;
        const Filter& filter = material.filter;
        for (const auto kind : {static_cast<unsigned>(interface.kind), static_cast<unsigned>(interface.finish),
                                static_cast<unsigned>(material.base), static_cast<unsigned>(filter.kind),
                                unsigned{material.thin}, unsigned{material.double_sided}, unsigned{material.texture}})
            add(std::uint64_t{kind});
        for (const glm::vec3& v : {interface.n, interface.k, material.albedo, filter.retardance, material.emission})
            add(v);
        for (const float x : {interface.slope, interface.rms_height, interface.correlation_length, filter.angle,
                              material.alpha, material.alpha_cutoff})
            add(x);
    }
    void add(const SurfaceTexture& texture) {
        for (const auto x :
             {static_cast<unsigned>(texture.width), static_cast<unsigned>(texture.height),
              static_cast<unsigned>(texture.wrap_u), static_cast<unsigned>(texture.wrap_v), unsigned{texture.nearest}})
            add(std::uint64_t{x});
        const std::vector<std::uint8_t>& bytes = *texture.texels;
        for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
            std::uint64_t word = 0;
            std::memcpy(&word, &bytes[i], std::min(sizeof word, bytes.size() - i));
            add(word);
        }
    }
    void add(const Lamp& lamp) {
        add(static_cast<std::uint64_t>(lamp.kind));
        for (const glm::vec3& v : {lamp.power, lamp.intensity, lamp.position, lamp.direction, lamp.polarization,
                                   lamp.axis, lamp.second_axis})
            add(v);
        for (const float x : {lamp.cos_inner, lamp.cos_outer, lamp.angular_radius}) add(x);
        add(std::uint64_t{lamp.chart});
    }
    template <class Item>
    void add(const std::vector<Item>& items) {
        add(static_cast<std::uint64_t>(items.size()));
        for (const Item& item : items) add(item);
    }

    std::string hexadecimal() const { return digest_.hexadecimal(); }

  private:
    Digest digest_;
};

}  // namespace

std::string scene_hash(const Scene& scene) {
    SceneHash hash;
    hash.add(scene.vertices);
    hash.add(scene.normals);
    hash.add(scene.texture_coordinates);
    hash.add(scene.vertex_colors);
    hash.add(scene.triangles);
    hash.add(scene.charts);
    hash.add(scene.materials);
    hash.add(scene.textures);
    hash.add(scene.lamps);
    return hash.hexadecimal();
}

}  // namespace brewster
