#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "scene/scene.h"

namespace brewster {

/// A scene file in the making: black walls, grey walls, lamps.
class SceneFile {
  public:
    SceneFile();
    ~SceneFile();
    SceneFile(SceneFile&&) noexcept;

    /// Lambert without an interface; `more`: JSON that is merged into the material.
    int material(double albedo, double emission = 0, const std::string& more = "{}");
    /// A rectangle whose front looks along cross(along, up); its node's name is its chart's.
    void quad(const std::string& name, glm::vec3 corner, glm::vec3 along, glm::vec3 up, int material);
    void triangles(const std::string& name, const std::vector<glm::vec3>& vertices,
                   const std::vector<std::array<std::uint32_t, 3>>& triangles, int material);
    void box(const std::string& name, glm::vec3 low, glm::vec3 high, bool inward, int material);
    void sun(double lux, glm::dvec3 towards);
    void bulb(double candela, glm::dvec3 position);
    void camera(const std::string& name, glm::dvec3 position);            ///< looks along -z
    void node_changes(const std::string& mesh, const std::string& more);  ///< JSON merged into its node

    std::string text() const;
    Scene read() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// A mean over seeds with its standard error.
struct Measured {
    double mean = 0, error = 0;
};

/// The same photons from several seeds.
struct Solved {
    std::shared_ptr<const Scene> scene;
    std::vector<Measured> irradiance;  ///< per chart: lux, mean of the bands, of what enters its base
    Measured everywhere;               ///< the mean over all charts by their area
    std::uint64_t bounces = 0, largest_bytes = 0;
    double escaped = 0;  ///< share of the light

    const Measured& on(const std::string& mesh, std::size_t side = 0) const {
        return irradiance[scene->charts_of(mesh)[side]];
    }
};

/// Solves, and expects what is promised of every run: accounts that balance, no trouble, numbers that are finite.
Solved solved(const SceneFile& file, std::uint64_t photons, const EngineSettings& settings = {}, int seeds = 8);

/// Within 4 standard errors (of 8 seeds; they are fixed, so this holds or it does not) and a thousandth, by a
/// measurement that could tell a tenth.
void expect_value(const Measured& measured, double expected, const char* what);

/// For JSON: all digits.
std::string digits(double number);

/// The sentence that the file ends in, or "none".
std::string sentence_of(const SceneFile& file);

}  // namespace brewster
