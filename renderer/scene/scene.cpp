#include "scene/scene.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"

namespace brewster {
namespace {

std::string quoted_list(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "\"" : ", \"") + name + "\"";
    return list;
}

}  // namespace

float Scene::radius() const {
    return glm::length(glm::max(glm::abs(low), glm::abs(high)));
}

const Camera& Scene::camera(const std::string& camera_name) const {
    const auto of_node =
        std::find_if(cameras.begin(), cameras.end(), [&](const Camera& camera) { return camera.name == camera_name; });
    if (of_node != cameras.end()) return *of_node;
    const auto is_own = [&](const Camera& camera) { return camera.file_name == camera_name; };
    if (std::count_if(cameras.begin(), cameras.end(), is_own) == 1)
        return *std::find_if(cameras.begin(), cameras.end(), is_own);
    std::vector<std::string> names;
    for (const Camera& camera : cameras) names.push_back(camera.name);
    throw Error("it has no camera \"" + camera_name + "\"", name, "choose one of " + quoted_list(names));
}

std::vector<std::uint32_t> Scene::charts_of(const std::string& mesh_name) const {
    std::vector<std::uint32_t> of_node, of_mesh;
    bool unique = true;
    for (std::uint32_t i = 0; i < charts.size(); ++i) {
        if (charts[i].mesh == mesh_name) of_node.push_back(i);
        if (charts[i].mesh_name != mesh_name) continue;
        of_mesh.push_back(i);
        unique = unique && charts[i].mesh == charts[of_mesh.front()].mesh;
    }
    if (!of_node.empty()) return of_node;
    if (!of_mesh.empty() && unique) return of_mesh;
    std::vector<std::string> names;
    for (const Chart& chart : charts) names.push_back(chart.mesh);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    throw Error("it has no mesh \"" + mesh_name + "\"", name, "choose one of " + quoted_list(names));
}

std::vector<bool> Scene::is_of(const std::string& mesh_name) const {
    std::vector<bool> flags(charts.size());
    for (const std::uint32_t chart : charts_of(mesh_name)) flags[chart] = true;
    return flags;
}

std::vector<double> Scene::area_shares(const Chart& chart) const {
    std::vector<double> sums;
    double sum = 0;
    for (std::uint32_t i = 0; i < chart.triangle_count; ++i) {
        const Triangle& triangle = triangles[chart.first_triangle + i];
        const glm::dvec3 a(vertices[triangle.vertices[0]]), b(vertices[triangle.vertices[1]]),
            c(vertices[triangle.vertices[2]]);
        sums.push_back(sum += 0.5 * glm::length(glm::cross(b - a, c - a)));
    }
    for (double& share : sums) share /= sum;
    sums.back() = 1.0;
    return sums;
}

glm::vec3 Scene::total_power() const {
    glm::vec3 sum(0.0f);
    for (const Lamp& lamp : lamps) sum += lamp.power;
    return sum;
}

glm::vec3 Scene::facet_normal(const Triangle& triangle) const {
    const glm::vec3 p0 = vertices[triangle.vertices[0]];
    return glm::normalize(glm::cross(vertices[triangle.vertices[1]] - p0, vertices[triangle.vertices[2]] - p0));
}

glm::vec3 Scene::shading_normal(const Triangle& triangle, glm::vec3 facet_normal, float b1, float b2) const {
    if (normals.empty()) return facet_normal;
    const glm::vec3 sum = (1.0f - b1 - b2) * normals[triangle.vertices[0]] + b1 * normals[triangle.vertices[1]] +
                          b2 * normals[triangle.vertices[2]];
    const float length = glm::length(sum);
    constexpr float shortest = 1e-3f, least_cosine = 1e-3f;
    if (length < shortest || glm::dot(sum, facet_normal) < least_cosine * length) return facet_normal;
    return sum / length;
}

glm::vec3 Scene::point_inside(const Triangle& triangle, float b1, float b2) const {
    float b[3] = {1.0f - b1 - b2, b1, b2};
    float sum = 0;
    for (int k = 0; k < 3; ++k) {
        if (b[k] < triangle.margin[k]) b[k] = triangle.margin[k];
        sum += b[k];
    }
    int largest = b[1] > b[0] ? 1 : 0;
    if (b[2] > b[largest]) largest = 2;
    b[largest] -= sum - 1.0f;
    const glm::vec3 p0 = vertices[triangle.vertices[0]];
    const glm::vec3 e1 = vertices[triangle.vertices[1]] - p0, e2 = vertices[triangle.vertices[2]] - p0;
    return p0 + b[1] * e1 + b[2] * e2;
}

}  // namespace brewster
