#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <tuple>

#include "base/error.h"
#include "base/one_line.h"
#include "base/units.h"
#include "scene/accessor.h"
#include "scene/contacts.h"
#include "scene/gltf_parse.h"
#include "scene/read_lamp.h"
#include "scene/read_material.h"
#include "scene/read_mesh.h"
#include "scene/read_nodes.h"
#include "scene/read_textures.h"
#include "scene/scene.h"
#include "scene/surfaces.h"
#include "scene/validate.h"

namespace brewster {
namespace {

constexpr std::size_t most_triangles = 10'000'000;            // half a kilobyte each, once they are charts
constexpr double smallest_scene = 1e-5, largest_scene = 1e8;  // metres; areas and powers stay well inside floats

// A primitive and whose it is.
struct MeshPart {
    std::size_t node = 0;
    std::string node_name, mesh_name;
    std::uint32_t material = 0;
    glm::dvec3 axis_x{1, 0, 0}, axis_y{0, 1, 0};  // of the node
    PlacedPrimitive placed;
};

// What a part's vertices look like.
struct Look {
    std::vector<glm::vec2> coordinates;
    std::vector<glm::vec4> colors;
    bool textured = false, coloured = false;  // whether any of them says more than the default

    void add(const PlacedPrimitive& placed, const GltfTextureUse& use) {
        const std::size_t count = colors.size() + placed.vertices.size();
        textured = textured || (use.present() && !placed.texture_coordinates.empty());
        coloured = coloured || !placed.colors.empty();
        for (const glm::vec2 each : placed.texture_coordinates) coordinates.push_back(transformed(use, each));
        coordinates.resize(count);
        colors.insert(colors.end(), placed.colors.begin(), placed.colors.end());
        colors.resize(count, glm::vec4(1.0f));
    }
};

std::string first_name(const std::string& node, const std::string& own, const std::string& kind, std::size_t index) {
    if (!node.empty()) return node;
    return own.empty() ? kind + " " + std::to_string(index) : own;
}

class Reader {
  public:
    Reader(const GltfFile& file, const std::string& where, const std::string& name)
        : file_(file),
          where_(where),
          nodes_(placed_nodes(file)),
          world_transforms_(world_transforms(file)),
          textures_(file, where, scene_.warnings) {
        scene_.name = name;
    }

    Scene read() {
        count_triangles();
        warn_of_the_unread();
        read_materials();
        for (const PlacedNode& node : nodes_) place_mesh(node);
        recentre();
        add_parts();
        place_lamps_and_cameras();
        warn_of_thin_shells();
        complete_lamps(scene_);
        scene_.contacts = chart_contacts(scene_);
        return std::move(scene_);
    }

  private:
    void warn(const std::string& sentence) { scene_.warnings.push_back(sentence); }

    void warn_of_the_unread() {
        static const std::set<std::string> read = {
            "KHR_lights_punctual",        "KHR_materials_emissive_strength",
            "KHR_materials_ior",          "KHR_materials_specular",
            "KHR_mesh_quantization",      "KHR_texture_transform",
            "KHR_materials_transmission", "KHR_materials_volume",
            "BREWSTER_surface",           "KHR_materials_unlit"};  // the last four are said of each material
        std::set<std::string> said;
        for (const std::string& name : file_.extensions_used)
            if (read.count(name) == 0 && said.insert(name).second)
                warn("the extension " + one_line(name) + " is not read");
        if (file_.has_animations) warn("animations are not played; the scene stands as its nodes say");
        if (file_.scenes.size() > 1) {
            const auto shown = static_cast<std::size_t>(std::max(file_.scene, 0));
            warn("it holds " + std::to_string(file_.scenes.size()) + " scenes; " +
                 first_name(file_.scenes[shown].name.empty() ? "" : "\"" + file_.scenes[shown].name + "\"", "", "scene",
                            shown) +
                 " is shown");
        }
    }

    void read_materials() {
        std::set<std::string> names;
        for (std::size_t i = 0; i < file_.materials.size(); ++i) {
            GltfMaterial from = file_.materials[i];
            const std::string subject = "material \"" + material_name(from, i) + "\": ";
            const std::vector<std::string>& extensions = from.extensions;
            if (std::find(extensions.begin(), extensions.end(), "KHR_materials_unlit") != extensions.end()) {
                warn(subject + "it is unlit in the file; it is a Lambert surface of its base colour");
                from.metallic = from.specular = 0;
            }
            from = with_texture_means(std::move(from), subject, textures_, scene_.warnings);
            Material material = read_material(from, i, scene_.warnings);
            set_texture(material, from, textures_);
            if (material.alpha_cutoff > 0 && material.emits())
                warn(subject + "its holes glow as if they were not cut out");
            const std::string wanted = material.name;
            for (int k = 2; !names.insert(material.name).second; ++k) material.name = wanted + " " + std::to_string(k);
            if (material.name != wanted)
                warn("material \"" + wanted + "\" is there twice; the second is called \"" + material.name + "\"");
            scene_.materials.push_back(std::move(material));
        }
        scene_.textures = textures_.take();
    }

    std::uint32_t default_material_index() {
        if (default_material_ == no_chart) {
            default_material_ = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.push_back(default_material());
        }
        return default_material_;
    }

    void place_mesh(const PlacedNode& placed) {
        const GltfNode& node = file_.nodes[placed.index];
        if (node.mesh < 0) return;
        const GltfMesh& mesh = file_.meshes[static_cast<std::size_t>(node.mesh)];
        const std::string name = first_name(node.name, mesh.name, "mesh", static_cast<std::size_t>(node.mesh));
        const std::string subject = "mesh \"" + name + "\": ";
        MeshPlace place{placed.to_world, {}};
        if (node.skin >= 0) {
            place.joints = joint_transforms(file_.skins[static_cast<std::size_t>(node.skin)]);
            warn(subject + "its skin is not animated; it stands as its joints do in the file");
        }
        bool morphs = false, without_material = false, other_modes = false, without_coordinates = false,
             uncoloured = false;
        std::size_t mended_normals = 0;
        for (const GltfPrimitive& primitive : mesh.primitives) {
            morphs = morphs || primitive.has_morph_targets;
            if (primitive.mode < gltf_triangles) {
                other_modes = true;
                continue;
            }
            MeshPart part{
                placed.index, name, mesh.name, 0, glm::dvec3(placed.to_world[0]), glm::dvec3(placed.to_world[1]), {}};
            part.material =
                primitive.material < 0 ? default_material_index() : static_cast<std::uint32_t>(primitive.material);
            part.placed = place_primitive(file_, primitive, place, base_use(part.material).set);
            const Material& material = scene_.materials[part.material];
            without_material = without_material || primitive.material < 0;
            without_coordinates =
                without_coordinates || (material.texture != no_texture && part.placed.texture_coordinates.empty());
            uncoloured = uncoloured || (material.albedo == glm::vec3(0.0f) && !part.placed.colors.empty());
            mended_normals += part.placed.mended_normals;
            if (!part.placed.triangles.empty()) parts_.push_back(std::move(part));
        }
        if (!said_meshes_.insert(node.mesh).second) return;
        const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
        if (morphs && std::any_of(weights.begin(), weights.end(), [](double weight) { return weight != 0; }))
            warn(subject + "its morph targets are not read; it stands in its rest pose");
        if (without_coordinates)
            warn(subject + "it has no coordinates for its texture; the first texel colours all of it");
        if (uncoloured) warn(subject + "the colours of its vertices are not simulated on its material");
        if (without_material) warn(subject + "it has no material and gets Lambert of albedo 0.8");
        if (other_modes) warn(subject + "its points and lines are left out; they have no surface");
        if (mended_normals > 0)
            warn(subject + std::to_string(mended_normals) +
                 " of its normals have no length; the mean of the facets "
                 "around them stands in");
    }

    // Before any is placed: a small file may place a mesh many times.
    void count_triangles() const {
        std::size_t count = 0;
        for (const PlacedNode& placed : nodes_) {
            const int mesh = file_.nodes[placed.index].mesh;
            if (mesh < 0) continue;
            for (const GltfPrimitive& primitive : file_.meshes[static_cast<std::size_t>(mesh)].primitives)
                count += triangle_count(file_, primitive);
        }
        if (count > most_triangles)
            throw Error("it has " + std::to_string(count) + " triangles, more than " +
                            std::to_string(most_triangles / 1'000'000) + " million",
                        where_, "simplify its meshes");
    }

    const GltfTextureUse& base_use(std::uint32_t material) const {
        static const GltfTextureUse none;
        return material < file_.materials.size() ? file_.materials[material].base_color_texture : none;
    }

    std::vector<glm::dmat4> joint_transforms(const GltfSkin& skin) const {
        std::vector<glm::dmat4> joints;
        for (std::size_t k = 0; k < skin.joints.size(); ++k) {
            glm::dmat4 to_joint(1.0);  // the inverse bind matrix
            if (skin.inverse_bind_matrices >= 0)
                for (int i = 0; i < 16; ++i)
                    to_joint[i / 4][i % 4] = static_cast<double>(
                        read_float(file_, file_.accessors[static_cast<std::size_t>(skin.inverse_bind_matrices)], k,
                                   static_cast<std::size_t>(i)));
            joints.push_back(world_transforms_[static_cast<std::size_t>(skin.joints[k])] * to_joint);
        }
        return joints;
    }

    void recentre() {
        if (parts_.empty()) throw Error("it has no triangles", where_, "choose a file with surfaces");
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (const MeshPart& part : parts_)
            for (const glm::dvec3& p : part.placed.vertices) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
        const double size = glm::length(high - low);
        if (!(size > smallest_scene && size < largest_scene))
            throw Error("it is " + std::to_string(size) + " m across", where_,
                        "scale it to between 0.01 mm and 100000 km");
        scene_.centre = 0.5 * (low + high);
        scene_.low = glm::vec3(low - scene_.centre);
        scene_.high = glm::vec3(high - scene_.centre);
    }

    // Primitives of one node and material, all flat or all smooth, become one part, so that their planes are charts
    // together.
    void add_parts() {
        std::vector<Part> parts;
        std::vector<Look> looks;
        std::map<std::tuple<std::size_t, std::uint32_t, bool>, std::size_t> known;
        for (const MeshPart& from : parts_) {
            const PlacedPrimitive& placed = from.placed;
            const auto [at, is_new] =
                known.try_emplace({from.node, from.material, placed.normals.empty()}, parts.size());
            if (is_new) {
                parts.push_back(
                    {from.node_name, from.mesh_name, from.material, {}, {}, {}, {}, {}, from.axis_x, from.axis_y});
                looks.emplace_back();
            }
            Part& part = parts[at->second];
            const auto first = static_cast<std::uint32_t>(part.vertices.size());
            for (const glm::dvec3& p : placed.vertices) part.vertices.emplace_back(p - scene_.centre);
            part.normals.insert(part.normals.end(), placed.normals.begin(), placed.normals.end());
            for (const auto& [a, b, c] : placed.triangles) part.triangles.push_back({first + a, first + b, first + c});
            looks[at->second].add(placed, base_use(from.material));
        }
        std::size_t without_area = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (looks[i].textured) parts[i].texture_coordinates = looks[i].coordinates;
            if (looks[i].coloured) parts[i].colors = looks[i].colors;
            without_area += add_surfaces(scene_, parts[i]);
            add_look(looks[i]);
        }
        if (scene_.triangles.empty()) throw Error("none of its triangles has an area", where_, "export it again");
        if (without_area > 0) warn(std::to_string(without_area) + " triangles without area are left out");
    }

    // Exporters leave the thickness out, and a ball of glass becomes a bubble.
    void warn_of_thin_shells() {
        std::set<std::uint32_t> said;
        for (const Chart& chart : scene_.charts) {
            const Material& material = scene_.materials[chart.material];
            const bool pane = material.thin && material.interface.present();
            if (pane && chart.curved && said.insert(chart.material).second)
                warn("material \"" + material.name +
                     "\": it is a thin shell, not a body, since it has no thickness of KHR_materials_volume");
        }
    }

    // Colours and texture coordinates of the vertices that a part has just brought into the scene.
    void add_look(const Look& look) {
        const std::size_t first = scene_.vertices.size() - look.colors.size();
        if (look.textured || !scene_.texture_coordinates.empty()) {
            scene_.texture_coordinates.resize(first);
            scene_.texture_coordinates.insert(scene_.texture_coordinates.end(), look.coordinates.begin(),
                                              look.coordinates.end());
        }
        if (look.coloured || !scene_.vertex_colors.empty()) {
            scene_.vertex_colors.resize(first, glm::vec4(1.0f));
            scene_.vertex_colors.insert(scene_.vertex_colors.end(), look.colors.begin(), look.colors.end());
        }
    }

    void place_lamps_and_cameras() {
        for (const PlacedNode& placed : nodes_) {
            const GltfNode& node = file_.nodes[placed.index];
            glm::dmat4 to_scene = placed.to_world;
            to_scene[3] -= glm::dvec4(scene_.centre, 0.0);
            if (node.light >= 0) {
                const GltfLight& light = file_.lights[static_cast<std::size_t>(node.light)];
                const std::string name =
                    first_name(node.name, light.name, "light", static_cast<std::size_t>(node.light));
                scene_.lamps.push_back(read_lamp(light, name, to_scene, scene_.warnings));
            }
            if (node.camera >= 0) place_camera(node, to_scene);
        }
        if (scene_.cameras.empty()) scene_.cameras.push_back(fitting_camera());
    }

    void place_camera(const GltfNode& node, const glm::dmat4& to_scene) {
        const GltfCamera& from = file_.cameras[static_cast<std::size_t>(node.camera)];
        Camera camera;
        camera.file_name = from.name;
        camera.name = first_name(node.name, from.name, "camera", static_cast<std::size_t>(node.camera));
        if (from.type != "perspective") {
            warn("camera \"" + camera.name + "\": its type " + from.type + " is not simulated; it is left out");
            return;
        }
        const glm::dvec3 forward = -glm::dvec3(to_scene[2]), up = glm::dvec3(to_scene[1]);
        const glm::dvec3 upright = glm::cross(glm::cross(forward, up), forward);
        if (!(glm::length(upright) > 0)) {
            warn("camera \"" + camera.name + "\": its node has no extent, so it looks nowhere; it is left out");
            return;
        }
        camera.position = glm::vec3(glm::dvec3(to_scene[3]));
        camera.forward = glm::vec3(glm::normalize(forward));
        camera.up = glm::vec3(glm::normalize(upright));
        camera.vertical_field_of_view = static_cast<float>(from.vertical_field_of_view);
        camera.near_distance = static_cast<float>(from.near_distance);
        if (from.aspect_ratio > 0) camera.aspect_ratio = static_cast<float>(from.aspect_ratio);
        const std::string wanted = camera.name;
        for (int k = 2; name_is_taken(camera.name); ++k) camera.name = wanted + " " + std::to_string(k);
        if (camera.name != wanted)
            warn("camera \"" + wanted + "\" is there twice; the second is called \"" + camera.name + "\"");
        scene_.cameras.push_back(camera);
    }

    bool name_is_taken(const std::string& name) const {
        return std::any_of(scene_.cameras.begin(), scene_.cameras.end(),
                           [&](const Camera& camera) { return camera.name == name; });
    }

    // From the front, a little from above and the side, so far that the sphere around the bounds fills the height.
    Camera fitting_camera() const {
        Camera camera;
        camera.name = "fit";
        const glm::vec3 towards = glm::normalize(glm::vec3(0.35f, 0.3f, 1.0f));
        const float distance = scene_.radius() / std::sin(0.5f * camera.vertical_field_of_view);
        camera.position = distance * towards;
        camera.forward = -towards;
        camera.up = glm::normalize(glm::vec3(0, 1, 0) - towards.y * towards);
        camera.near_distance = 0.01f * scene_.radius();
        return camera;
    }

    const GltfFile& file_;
    const std::string& where_;
    Scene scene_;
    std::vector<PlacedNode> nodes_;
    std::vector<glm::dmat4> world_transforms_;  // of all nodes
    TextureReader textures_;
    std::vector<MeshPart> parts_;
    std::set<int> said_meshes_;  // of which everything was said at their first node
    std::uint32_t default_material_ = no_chart;
};

Scene read_bytes(std::span<const unsigned char> bytes, const std::filesystem::path& folder, const std::string& where,
                 const std::string& name) {
    const GltfFile file = parse_gltf(bytes, folder, where);
    validate(file, where);
    return Reader(file, where, name).read();
}

}  // namespace

Scene read_scene(const std::string& path) {
    std::error_code unreadable;
    if (!std::filesystem::exists(path, unreadable)) throw Error("there is no such file", path, "check its name");
    if (!std::filesystem::is_regular_file(path, unreadable))
        throw Error("it is not a file", path, "name a .gltf or .glb file");
    std::ifstream stream(path, std::ios::binary);
    const std::vector<unsigned char> bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream) throw Error("it cannot be read", path, "check its permissions");
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    return read_bytes(bytes, folder, path, std::filesystem::path(path).stem().string());
}

Scene read_scene_text(std::string_view text, const std::string& name) {
    return read_bytes({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, {}, name, name);
}

}  // namespace brewster
