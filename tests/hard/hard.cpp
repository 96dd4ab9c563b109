#include "hard/hard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "bins/lookup.h"
#include "engine/slow.h"
#include "scene/gltf_builder.h"

namespace brewster {

struct SceneFile::Impl {
    GltfBuilder builder;
    int materials = 0;
};

SceneFile::SceneFile() : impl_(std::make_unique<Impl>()) {}
SceneFile::~SceneFile() = default;
SceneFile::SceneFile(SceneFile&&) noexcept = default;

int SceneFile::material(double albedo, double emission, const std::string& more) {
    const int index = impl_->builder.add_material("material " + std::to_string(impl_->materials++),
                                                  {albedo, albedo, albedo}, emission);
    impl_->builder.json["materials"][static_cast<std::size_t>(index)].merge_patch(nlohmann::json::parse(more));
    return index;
}

void SceneFile::quad(const std::string& name, glm::vec3 corner, glm::vec3 along, glm::vec3 up, int material) {
    impl_->builder.add_polygon(name, {corner, corner + along, corner + along + up, corner + up}, material);
}

void SceneFile::triangles(const std::string& name, const std::vector<glm::vec3>& vertices,
                          const std::vector<std::array<std::uint32_t, 3>>& triangles, int material) {
    impl_->builder.add_mesh(name, vertices, triangles, material);
}

void SceneFile::box(const std::string& name, glm::vec3 low, glm::vec3 high, bool inward, int material) {
    impl_->builder.add_box(name, low, high, inward, material);
}

void SceneFile::sun(double lux, glm::dvec3 towards) {
    auto& lights = impl_->builder.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "directional"}, {"intensity", lux}});
    const glm::dvec3 z = -glm::normalize(towards);
    const glm::dvec3 x = glm::normalize(glm::cross(std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), z));
    const glm::dvec3 y = glm::cross(z, x);
    impl_->builder.add_node({{"matrix", {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1}},
                             {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
}

void SceneFile::bulb(double candela, glm::dvec3 position) {
    auto& lights = impl_->builder.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "point"}, {"intensity", candela}});
    impl_->builder.add_node({{"translation", {position.x, position.y, position.z}},
                             {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
}

void SceneFile::camera(const std::string& name, glm::dvec3 position) {
    auto& cameras = impl_->builder.json["cameras"];
    cameras.push_back({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.001}}}});
    impl_->builder.add_node(
        {{"name", name}, {"translation", {position.x, position.y, position.z}}, {"camera", cameras.size() - 1}});
}

void SceneFile::node_changes(const std::string& mesh, const std::string& more) {
    for (auto& node : impl_->builder.json["nodes"])
        if (node.contains("name") && node["name"] == mesh) node.merge_patch(nlohmann::json::parse(more));
}

std::string SceneFile::text() const {
    return impl_->builder.text();
}

Scene SceneFile::read() const {
    return read_scene_text(text(), "hard");
}

namespace {

// The cells are linear, so the mean over a fine lattice is the mean over the chart but for where cells end.
double mean_irradiance(const Snapshot& bins, std::uint32_t chart) {
    constexpr std::uint32_t side = 64, step = (1u << 24) / side;
    double sum = 0;
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t j = 0; j < side; ++j)
            for (const std::uint32_t root : {bins.charts[chart].direct_root, bins.charts[chart].indirect_root}) {
                const auto value = lookup::look_up(bins, root, 0u, i * step + step / 2, j * step + step / 2).value;
                sum += (static_cast<double>(value.x) + static_cast<double>(value.y) + static_cast<double>(value.z)) / 3;
            }
    return sum / (side * side);
}

// Sums of a value and its square over seeds.
struct Sum {
    double value = 0, square = 0;
    void add(double x) {
        value += x;
        square += x * x;
    }
    Measured mean_of(int seeds) const {
        const double mean = value / seeds;
        return {mean, std::sqrt(std::max(square / seeds - mean * mean, 0.0) / (seeds - 1))};
    }
};

}  // namespace

Solved solved(const SceneFile& file, std::uint64_t photons, const EngineSettings& settings, int seeds) {
    Solved result;
    result.scene = std::make_shared<const Scene>(file.read());
    const std::vector<Chart>& charts = result.scene->charts;
    double whole = 0;
    for (const Chart& chart : charts) whole += chart.area;
    std::vector<Sum> sums(charts.size());
    Sum everywhere;
    for (int k = 0; k < seeds; ++k) {
        EngineSettings each = settings;
        each.threads = 2;
        each.seed = settings.seed + static_cast<std::uint64_t>(k);
        Engine engine(result.scene, each);
        engine.start({photons, {}, {}});
        engine.wait();
        const Progress progress = engine.progress();
        const Ledger ledger = engine.ledger();
        EXPECT_TRUE(ledger.balances());
        EXPECT_EQ(progress.trouble, 0u);
        result.bounces += progress.bounces;
        result.largest_bytes = std::max(result.largest_bytes, progress.bytes);
        result.escaped += static_cast<double>(ledger.escaped[0][0]) / static_cast<double>(ledger.emitted[0][0]) / seeds;
        double mean = 0;
        for (std::uint32_t chart = 0; chart < charts.size(); ++chart) {
            const double value = mean_irradiance(*engine.snapshot(), chart);
            EXPECT_TRUE(std::isfinite(value)) << charts[chart].mesh;
            sums[chart].add(value);
            mean += value * charts[chart].area / whole;
        }
        everywhere.add(mean);
    }
    for (const Sum& sum : sums) result.irradiance.push_back(sum.mean_of(seeds));
    result.everywhere = everywhere.mean_of(seeds);
    return result;
}

std::string digits(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.16e", number);
    return text.data();
}

void expect_value(const Measured& measured, double expected, const char* what) {
    std::printf("%s: %.6g +- %.2g, expected %.6g\n", what, measured.mean, measured.error, expected);
    EXPECT_NEAR(measured.mean, expected, 4 * measured.error + 1e-3 * std::abs(expected)) << what;
    EXPECT_LT(measured.error, 0.1 * std::abs(expected)) << what;
}

std::string sentence_of(const SceneFile& file) {
    try {
        file.read();
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

}  // namespace brewster
