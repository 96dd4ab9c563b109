#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "base/units.h"
#include "scene/accessor.h"

namespace brewster {
namespace {

// Messages say `meshes[2].primitives[0].indices`: the path of the fault in the file.
std::string item(const std::string& list, std::size_t i) {
    return list + "[" + std::to_string(i) + "]";
}

// More elements than a file that can be read has, however often its lists name the same bytes.
constexpr std::size_t most_elements = std::size_t{1} << 29;

struct Validator {
    const GltfFile& file;
    const std::string& where;
    mutable std::set<std::pair<int, bool>> finite{};       // accessors whose numbers were looked at
    mutable std::map<int, std::uint32_t> largest_index{};  // of accessors of indices
    mutable std::size_t elements = 0;                      // looked at so far

    // Reads each accessor once: many primitives may share it.
    void count_elements(std::size_t count) const {
        elements += count;
        if (elements > most_elements)
            throw Error("its accessors hold more than " + std::to_string(most_elements / 1'000'000) +
                            " million elements together",
                        where, "simplify its meshes");
    }

    [[noreturn]] void wrong(const std::string& path, const std::string& fault) const {
        throw Error("\"" + path + "\" " + fault, where, "export the file again or mend it by hand");
    }

    template <class Item>
    void check_index(int index, const std::vector<Item>& list, const std::string& path,
                     const std::string& list_name) const {
        if (index < 0 || static_cast<std::size_t>(index) >= list.size())
            wrong(path,
                  "is " + std::to_string(index) + ", but there are " + std::to_string(list.size()) + " " + list_name);
    }

    template <class Item>
    void check_optional_index(int index, const std::vector<Item>& list, const std::string& path,
                              const std::string& list_name) const {
        if (index != -1) check_index(index, list, path, list_name);
    }

    void check_range(double value, double low, double high, const std::string& path) const {
        if (!(value >= low && value <= high)) wrong(path, "is " + std::to_string(value) + ", out of range");
    }

    void check_ranges(const std::vector<double>& values, std::size_t count, double low, double high,
                      const std::string& path) const {
        if (values.size() != count) wrong(path, "does not hold " + std::to_string(count) + " numbers");
        for (const double value : values) check_range(value, low, high, path);
    }

    void check_optional_numbers(const std::vector<double>& values, std::size_t count, const std::string& path) const {
        constexpr double largest = 1e12;  // anything further is not a scene, and its square still fits a float
        if (!values.empty()) check_ranges(values, count, -largest, largest, path);
    }

    void check_extensions() const {
        static const std::vector<std::string> readable = {
            "KHR_lights_punctual",    "KHR_materials_emissive_strength", "KHR_materials_ior",
            "KHR_materials_specular", "KHR_materials_transmission",      "KHR_materials_volume",
            "BREWSTER_surface",       "KHR_mesh_quantization",           "KHR_texture_transform",
            "KHR_materials_unlit"};
        for (const std::string& name : file.extensions_required)
            if (std::find(readable.begin(), readable.end(), name) == readable.end())
                throw Error("it requires the extension " + name + ", which is not read", where,
                            "export the file without it");
    }

    void check_buffer_view(std::size_t i) const {
        const GltfBufferView& view = file.buffer_views[i];
        const std::string path = item("bufferViews", i);
        check_index(view.buffer, file.buffers, path + ".buffer", "buffers");
        const std::size_t size = file.buffers[static_cast<std::size_t>(view.buffer)].size();
        if (view.byte_length == 0) wrong(path + ".byteLength", "is 0");
        if (view.byte_offset > size || view.byte_length > size - view.byte_offset)
            wrong(path, "ends beyond its buffer of " + std::to_string(size) + " bytes");
        if (view.byte_stride != 0 && (view.byte_stride < 4 || view.byte_stride > 252 || view.byte_stride % 4 != 0))
            wrong(path + ".byteStride", "is " + std::to_string(view.byte_stride) + ", not 4, 8 .. 252");
    }

    // Accessors that nothing reads may be of any type, but never lie outside their bytes.
    void check_accessor(std::size_t i) const {
        const GltfAccessor& accessor = file.accessors[i];
        const std::string path = item("accessors", i);
        const std::size_t bytes = component_bytes(accessor.component_type);
        if (bytes == 0) wrong(path + ".componentType", "is " + std::to_string(accessor.component_type) + ", unknown");
        if (accessor.count == 0) wrong(path + ".count", "is 0");
        if (accessor.components == 0) return;
        check_sparse(accessor, path);
        if (accessor.buffer_view == -1) return;
        check_index(accessor.buffer_view, file.buffer_views, path + ".bufferView", "bufferViews");
        const GltfBufferView& view = file.buffer_views[static_cast<std::size_t>(accessor.buffer_view)];
        const std::size_t element = element_bytes(accessor);
        const std::size_t stride = element_stride(file, accessor);
        if (stride < element) wrong(path, "has elements that are larger than the stride of its bufferView");
        if (accessor.byte_offset % bytes != 0 || (view.byte_offset + accessor.byte_offset) % bytes != 0)
            wrong(path + ".byteOffset", "is not a multiple of the component's size");
        if (accessor.byte_offset > view.byte_length || view.byte_length - accessor.byte_offset < element ||
            accessor.count - 1 > (view.byte_length - accessor.byte_offset - element) / stride)
            wrong(path, "with its count of " + std::to_string(accessor.count) + " ends beyond its bufferView");
    }

    void check_sparse(const GltfAccessor& accessor, const std::string& accessor_path) const {
        if (!accessor.is_sparse) return;
        const GltfSparse& sparse = accessor.sparse;
        const std::string path = accessor_path + ".sparse";
        if (sparse.count == 0 || sparse.count > accessor.count)
            wrong(path + ".count",
                  "is " + std::to_string(sparse.count) + ", not 1 .. " + std::to_string(accessor.count));
        const int type = sparse.indices_type;
        if (type != gltf_unsigned_byte && type != gltf_unsigned_short && type != gltf_unsigned_int)
            wrong(path + ".indices.componentType", "is " + std::to_string(type) + ", not an unsigned integer");
        check_packed(sparse.indices_view, sparse.indices_offset, sparse.count, component_bytes(type),
                     component_bytes(type), path + ".indices");
        check_packed(sparse.values_view, sparse.values_offset, sparse.count, element_bytes(accessor),
                     component_bytes(accessor.component_type), path + ".values");
        for (std::size_t k = 0; k < sparse.count; ++k) {
            const std::uint32_t index = sparse_index(file, sparse, k);
            if (index >= accessor.count)
                wrong(path + ".indices",
                      "holds " + std::to_string(index) + ", but there are " + std::to_string(accessor.count));
            if (k > 0 && index <= sparse_index(file, sparse, k - 1)) wrong(path + ".indices", "do not increase");
        }
    }

    // `count` elements one after another, from an offset into a view.
    void check_packed(int view_index, std::size_t offset, std::size_t count, std::size_t element, std::size_t alignment,
                      const std::string& path) const {
        check_index(view_index, file.buffer_views, path + ".bufferView", "bufferViews");
        const GltfBufferView& view = file.buffer_views[static_cast<std::size_t>(view_index)];
        if ((view.byte_offset + offset) % alignment != 0)
            wrong(path + ".byteOffset", "is not a multiple of the component's size");
        if (offset > view.byte_length || count > (view.byte_length - offset) / element)
            wrong(path, "with its count of " + std::to_string(count) + " ends beyond its bufferView");
    }

    const GltfAccessor& check_read_accessor(int index, const std::string& path) const {
        check_index(index, file.accessors, path, "accessors");
        return file.accessors[static_cast<std::size_t>(index)];
    }

    // Of an accessor that is read: without bytes of its own, those of the whole file vouch for its length, or a small file
    // would take a long time.
    void check_zeros(int index) const {
        const GltfAccessor& accessor = file.accessors[static_cast<std::size_t>(index)];
        if (accessor.buffer_view != -1) return;
        std::size_t most_zeros = std::size_t{1} << 16;
        for (const auto& buffer : file.buffers) most_zeros = std::max(most_zeros, buffer.size());
        if (accessor.count > most_zeros)
            wrong(item("accessors", static_cast<std::size_t>(index)) + ".count",
                  "is " + std::to_string(accessor.count) + " without a bufferView, too large");
    }

    void check_primitive(const GltfPrimitive& primitive, const std::string& path) const {
        check_optional_index(primitive.material, file.materials, path + ".material", "materials");
        if (primitive.mode < 0 || primitive.mode > gltf_triangle_fan)
            wrong(path + ".mode", "is " + std::to_string(primitive.mode) + ", unknown");
        for (const auto& [name, index] : primitive.attributes)
            check_index(index, file.accessors, path + ".attributes." + name, "accessors");
        if (primitive.mode < gltf_triangles) return;  // not read, see the warnings

        const auto found = primitive.attributes.find("POSITION");
        if (found == primitive.attributes.end()) wrong(path, "has no POSITION");
        const GltfAccessor& positions = check_read_accessor(found->second, path + ".attributes.POSITION");
        std::size_t corners = positions.count;
        if (primitive.indices != -1) corners = check_vertex_indices(primitive, positions.count, path);
        if (primitive.mode == gltf_triangles ? corners % 3 != 0 : corners < 3)
            wrong(path, "has " + std::to_string(corners) + " triangle corners, " +
                            (primitive.mode == gltf_triangles ? "not a multiple of 3" : "fewer than 3"));
        for (const auto& [name, index] : primitive.attributes)
            check_attribute(name, index, positions.count, path + ".attributes." + name);
    }

    std::size_t check_vertex_indices(const GltfPrimitive& primitive, std::size_t vertices,
                                     const std::string& path) const {
        const GltfAccessor& indices = check_read_accessor(primitive.indices, path + ".indices");
        const int type = indices.component_type;
        if (indices.components != 1 ||
            (type != gltf_unsigned_byte && type != gltf_unsigned_short && type != gltf_unsigned_int))
            wrong(path + ".indices", "is not a SCALAR of unsigned integers");
        check_zeros(primitive.indices);
        const auto [known, is_new] = largest_index.try_emplace(primitive.indices, 0);
        if (is_new) {
            count_elements(indices.count);
            for (std::size_t i = 0; i < indices.count; ++i)
                known->second = std::max(known->second, read_index(file, indices, i));
        }
        const std::uint32_t largest = known->second, restart = 0xffffffffu >> (32 - 8 * component_bytes(type));
        if (largest == restart && primitive.mode != gltf_triangles)
            wrong(path + ".indices", "restarts its strip, which glTF forbids");
        if (largest >= vertices)
            wrong(path + ".indices",
                  "holds vertex " + std::to_string(largest) + ", but there are " + std::to_string(vertices));
        return indices.count;
    }

    // glTF 2.0, 3.7.2.1, widened by KHR_mesh_quantization, whether the file names it or not.
    void check_attribute(const std::string& name, int index, std::size_t vertices, const std::string& path) const {
        const GltfAccessor& accessor = check_read_accessor(index, path);
        const bool coordinates = name.rfind("TEXCOORD_", 0) == 0;
        if (name == "POSITION") {
            if (accessor.components != 3 || !is_small_or_float(accessor)) wrong(path, "is not a VEC3 of floats");
        } else if (name == "NORMAL") {
            if (accessor.components != 3 || !is_small_or_float(accessor)) wrong(path, "is not a VEC3 of floats");
        } else if (coordinates) {
            if (accessor.components != 2 || !is_small_or_float(accessor)) wrong(path, "is not a VEC2 of floats");
        } else if (name == "COLOR_0") {
            if ((accessor.components != 3 && accessor.components != 4) || !is_unsigned_or_float(accessor))
                wrong(path, "is not a VEC3 or VEC4 of floats or normalized unsigned integers");
        } else if (name.rfind("WEIGHTS_", 0) == 0) {
            if (accessor.components != 4 || !is_unsigned_or_float(accessor))
                wrong(path, "is not a VEC4 of floats or normalized unsigned integers");
        } else if (name.rfind("JOINTS_", 0) == 0) {
            if (accessor.components != 4 || accessor.normalized || accessor.component_type == gltf_float ||
                !is_unsigned_or_float(accessor))
                wrong(path, "is not a VEC4 of unsigned bytes or shorts");
        } else {
            return;  // not read
        }
        check_zeros(index);
        if (accessor.count != vertices)
            wrong(path, "holds " + std::to_string(accessor.count) + " elements for " + std::to_string(vertices) +
                            " vertices");
        if (!finite.insert({index, coordinates}).second) return;
        count_elements(accessor.count);
        for (std::size_t i = 0; i < accessor.count; ++i) {
            const glm::vec4 v = read_vector(file, accessor, i);
            if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z) || !std::isfinite(v.w))
                wrong(path, "holds a number that is not finite at vertex " + std::to_string(i));
            constexpr float furthest = 1e6f;  // beyond, floats have no texels to tell apart
            if (coordinates && std::max(std::abs(v.x), std::abs(v.y)) > furthest)
                wrong(path, "lies a million pictures away at vertex " + std::to_string(i));
        }
    }

    static bool is_small_or_float(const GltfAccessor& accessor) {
        return accessor.component_type == gltf_float || component_bytes(accessor.component_type) <= 2;
    }

    static bool is_unsigned_or_float(const GltfAccessor& accessor) {
        return accessor.component_type == gltf_float || accessor.component_type == gltf_unsigned_byte ||
               accessor.component_type == gltf_unsigned_short;
    }

    void check_skin(std::size_t i) const {
        const GltfSkin& skin = file.skins[i];
        const std::string path = item("skins", i);
        if (skin.joints.empty()) wrong(path + ".joints", "is empty");
        for (const int joint : skin.joints) check_index(joint, file.nodes, path + ".joints", "nodes");
        if (skin.inverse_bind_matrices < 0) return;
        const GltfAccessor& matrices = check_read_accessor(skin.inverse_bind_matrices, path + ".inverseBindMatrices");
        if (matrices.components != 16 || matrices.component_type != gltf_float)
            wrong(path + ".inverseBindMatrices", "is not a MAT4 of floats");
        if (matrices.count < skin.joints.size())
            wrong(path + ".inverseBindMatrices", "holds " + std::to_string(matrices.count) + " matrices for " +
                                                     std::to_string(skin.joints.size()) + " joints");
        for (std::size_t joint = 0; joint < skin.joints.size(); ++joint)
            for (std::size_t k = 0; k < 16; ++k)
                if (!std::isfinite(read_float(file, matrices, joint, k)))
                    wrong(path + ".inverseBindMatrices", "holds a number that is not finite");
    }

    std::uint32_t largest_joint(int index) const {
        const auto [known, is_new] = largest_index.try_emplace(index, 0);
        if (!is_new) return known->second;
        const GltfAccessor& accessor = file.accessors[static_cast<std::size_t>(index)];
        count_elements(accessor.count);
        float largest = 0;
        for (std::size_t i = 0; i < accessor.count; ++i) {
            const glm::vec4 named = read_vector(file, accessor, i);
            largest = std::max({largest, named.x, named.y, named.z, named.w});
        }
        return known->second = static_cast<std::uint32_t>(largest);
    }

    // Joints that a mesh's vertices name exist in the skin of each node that wears it.
    void check_worn_skin(const GltfNode& node, const std::string& path) const {
        check_optional_index(node.skin, file.skins, path + ".skin", "skins");
        if (node.skin < 0 || node.mesh < 0) return;
        const std::size_t joints = file.skins[static_cast<std::size_t>(node.skin)].joints.size();
        for (const GltfPrimitive& primitive : file.meshes[static_cast<std::size_t>(node.mesh)].primitives)
            for (const auto& [name, index] : primitive.attributes) {
                if (name.rfind("JOINTS_", 0) != 0 || primitive.mode < gltf_triangles) continue;
                const std::uint32_t largest = largest_joint(index);
                if (largest >= joints)
                    wrong(path, "wears a skin of " + std::to_string(joints) + " joints, but " + name + " names " +
                                    std::to_string(largest));
            }
    }

    void check_texture(std::size_t i) const {
        const std::string path = item("textures", i);
        check_optional_index(file.textures[i].source, file.images, path + ".source", "images");
        check_optional_index(file.textures[i].sampler, file.samplers, path + ".sampler", "samplers");
    }

    void check_sampler(std::size_t i) const {
        const GltfSampler& sampler = file.samplers[i];
        const std::string path = item("samplers", i);
        for (const int wrap : {sampler.wrap_s, sampler.wrap_t})
            if (wrap != gltf_clamp && wrap != gltf_mirror && wrap != gltf_repeat)
                wrong(path, "has the wrap mode " + std::to_string(wrap) + ", unknown");
        if (sampler.mag_filter != -1 && sampler.mag_filter != gltf_nearest && sampler.mag_filter != gltf_linear)
            wrong(path + ".magFilter", "is " + std::to_string(sampler.mag_filter) + ", unknown");
    }

    void check_use(const GltfTextureUse& use, const std::string& path) const {
        check_optional_index(use.texture, file.textures, path + ".index", "textures");
        constexpr double furthest = 1e6;  // beyond, floats have no texels to tell apart
        for (std::size_t k = 0; k < 2; ++k) {
            check_range(use.offset[k], -furthest, furthest, path + ".offset");
            check_range(use.scale[k], -furthest, furthest, path + ".scale");
        }
        check_range(use.rotation, -furthest, furthest, path + ".rotation");
    }

    void check_material(std::size_t i) const {
        const GltfMaterial& material = file.materials[i];
        const std::string path = item("materials", i);
        check_use(material.base_color_texture, path + ".pbrMetallicRoughness.baseColorTexture");
        check_use(material.metallic_roughness_texture, path + ".pbrMetallicRoughness.metallicRoughnessTexture");
        check_use(material.emissive_texture, path + ".emissiveTexture");
        check_use(material.specular_texture, path + ".extensions.KHR_materials_specular.specularTexture");
        check_use(material.specular_color_texture, path + ".extensions.KHR_materials_specular.specularColorTexture");
        check_use(material.transmission_texture, path + ".extensions.KHR_materials_transmission.transmissionTexture");
        check_use(material.thickness_texture, path + ".extensions.KHR_materials_volume.thicknessTexture");
        check_range(material.alpha_cutoff, 0, 1e12, path + ".alphaCutoff");
        constexpr double brightest = 1e12;
        check_ranges(material.base_color, 4, 0, 1, path + ".pbrMetallicRoughness.baseColorFactor");
        check_ranges(material.emissive, 3, 0, brightest, path + ".emissiveFactor");
        check_range(material.emissive_strength, 0, brightest, path + ".emissiveStrength");
        check_range(material.metallic, 0, 1, path + ".pbrMetallicRoughness.metallicFactor");
        check_range(material.roughness, 0, 1, path + ".pbrMetallicRoughness.roughnessFactor");
        check_range(material.specular, 0, 1, path + ".specularFactor");
        check_ranges(material.specular_color, 3, 0, brightest, path + ".specularColorFactor");
        if (material.ior != 0) check_range(material.ior, 1, 1e6, path + ".ior");
        check_range(material.transmission, 0, 1, path + ".transmissionFactor");
        check_range(material.thickness, 0, 1e12, path + ".thicknessFactor");
        check_surface(material.surface, path + ".extensions.BREWSTER_surface");
    }

    void check_surface(const GltfSurface& surface, const std::string& path) const {
        constexpr double widest = 1e4;  // micrometres; a rougher surface is geometry
        check_range(surface.rms_height, 0, widest, path + ".rmsHeight");
        check_range(surface.correlation_length, 0, widest, path + ".correlationLength");
        if ((surface.rms_height > 0) != (surface.correlation_length > 0))
            wrong(path, "holds one of rmsHeight and correlationLength without the other");
        if (surface.n.empty() != surface.k.empty())
            wrong(path + ".complexIor", "holds one of n and k without the other");
        if (!surface.n.empty()) {
            check_ranges(surface.n, 3, 1e-3, 100, path + ".complexIor.n");
            check_ranges(surface.k, 3, 0, 100, path + ".complexIor.k");
        }
        if (surface.polarizer && surface.retarder) wrong(path, "is both a polarizer and a retarder");
        check_range(surface.angle, -360, 360, path + ".angle");
        check_range(surface.retardance, -3600, 3600, path + ".retarder.retardance");
        check_range(surface.thickness, 0, 1e6, path + ".retarder.thickness");
        check_range(surface.birefringence, -1, 1, path + ".retarder.birefringence");
        const bool plate = surface.thickness != 0 && surface.birefringence != 0;
        if (surface.retarder && plate == (surface.retardance != 0))
            wrong(path + ".retarder", "needs either retardance or thickness and birefringence");
    }

    void check_camera(std::size_t i) const {
        const GltfCamera& camera = file.cameras[i];
        if (camera.type != "perspective") return;  // not read, see the warnings
        check_range(camera.vertical_field_of_view, 1e-4, pi - 1e-4, item("cameras", i) + ".perspective.yfov");
        check_range(camera.near_distance, 1e-9, 1e12, item("cameras", i) + ".perspective.znear");
        check_range(camera.aspect_ratio, 0, 1e4, item("cameras", i) + ".perspective.aspectRatio");
    }

    void check_light(std::size_t i) const {
        const GltfLight& light = file.lights[i];
        const std::string path = item("lights", i);
        if (light.type != "directional" && light.type != "point" && light.type != "spot")
            wrong(path + ".type", "is \"" + light.type + "\", not directional, point or spot");
        check_ranges(light.color, 3, 0, 1e6, path + ".color");
        check_range(light.intensity, 0, 1e12, path + ".intensity");
        check_range(light.dolp, 0, 1, path + ".polarization.dolp");
        check_range(light.docp, -1, 1, path + ".polarization.docp");
        check_range(light.dolp * light.dolp + light.docp * light.docp, 0, 1 + 1e-6,
                    path + ".polarization: dolp^2 + docp^2");
        check_range(light.aolp, -360, 360, path + ".polarization.aolp");
        check_range(light.angular_diameter, 0, 90, path + ".angularDiameter");
        if (light.type != "spot") return;
        check_range(light.outer_cone_angle, 1e-4, pi / 2 + 1e-9, path + ".spot.outerConeAngle");
        check_range(light.inner_cone_angle, 0, light.outer_cone_angle, path + ".spot.innerConeAngle");
    }

    void check_node(std::size_t i) const {
        const GltfNode& node = file.nodes[i];
        const std::string path = item("nodes", i);
        check_optional_index(node.mesh, file.meshes, path + ".mesh", "meshes");
        check_optional_index(node.camera, file.cameras, path + ".camera", "cameras");
        check_optional_index(node.light, file.lights, path + ".light", "lights");
        for (const int child : node.children) check_index(child, file.nodes, path + ".children", "nodes");
        check_optional_numbers(node.matrix, 16, path + ".matrix");
        check_optional_numbers(node.translation, 3, path + ".translation");
        check_optional_numbers(node.rotation, 4, path + ".rotation");
        if (!node.rotation.empty() &&
            std::all_of(node.rotation.begin(), node.rotation.end(), [](double q) { return q == 0; }))
            wrong(path + ".rotation", "is zero, not a unit quaternion");
        if (!node.matrix.empty() &&
            (node.matrix[3] != 0 || node.matrix[7] != 0 || node.matrix[11] != 0 || node.matrix[15] != 1))
            wrong(path + ".matrix", "does not end in the row 0 0 0 1");
        check_optional_numbers(node.scale, 3, path + ".scale");
        check_worn_skin(node, path);
    }

    std::vector<int> parent_counts() const {
        std::vector<int> parents(file.nodes.size(), 0);
        for (const GltfNode& node : file.nodes)
            for (const int child : node.children) ++parents[static_cast<std::size_t>(child)];
        return parents;
    }

    // Every node has one parent at most, and walking down from the nodes without one reaches all: no cycles.
    void check_forest() const {
        const std::vector<int> parents = parent_counts();
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < parents.size(); ++i) {
            if (parents[i] > 1) wrong(item("nodes", i), "is the child of several nodes");
            if (parents[i] == 0) open.push_back(i);
        }
        std::size_t reached = 0;
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            ++reached;
            for (const int child : file.nodes[i].children) open.push_back(static_cast<std::size_t>(child));
        }
        if (reached != file.nodes.size()) wrong("nodes", "contain themselves: their children form a cycle");
    }

    void check_scenes() const {
        check_optional_index(file.scene, file.scenes, "scene", "scenes");
        const std::vector<int> parents = parent_counts();
        for (std::size_t i = 0; i < file.scenes.size(); ++i) {
            std::vector<int> roots = file.scenes[i].nodes;
            for (const int root : roots) {
                check_index(root, file.nodes, item("scenes", i) + ".nodes", "nodes");
                if (parents[static_cast<std::size_t>(root)] != 0)
                    wrong(item("scenes", i) + ".nodes", "names node " + std::to_string(root) + ", which has a parent");
            }
            std::sort(roots.begin(), roots.end());
            if (std::adjacent_find(roots.begin(), roots.end()) != roots.end())
                wrong(item("scenes", i) + ".nodes", "names a node twice");
        }
    }
};

}  // namespace

void validate(const GltfFile& file, const std::string& where) {
    const Validator validator{file, where};
    validator.check_extensions();
    for (std::size_t i = 0; i < file.buffer_views.size(); ++i) validator.check_buffer_view(i);
    for (std::size_t i = 0; i < file.accessors.size(); ++i) validator.check_accessor(i);
    for (std::size_t i = 0; i < file.samplers.size(); ++i) validator.check_sampler(i);
    for (std::size_t i = 0; i < file.textures.size(); ++i) validator.check_texture(i);
    for (std::size_t i = 0; i < file.materials.size(); ++i) validator.check_material(i);
    for (std::size_t i = 0; i < file.skins.size(); ++i) validator.check_skin(i);
    for (std::size_t i = 0; i < file.cameras.size(); ++i) validator.check_camera(i);
    for (std::size_t i = 0; i < file.lights.size(); ++i) validator.check_light(i);
    for (std::size_t m = 0; m < file.meshes.size(); ++m)
        for (std::size_t p = 0; p < file.meshes[m].primitives.size(); ++p)
            validator.check_primitive(file.meshes[m].primitives[p], item(item("meshes", m) + ".primitives", p));
    for (std::size_t i = 0; i < file.nodes.size(); ++i) validator.check_node(i);
    validator.check_forest();
    validator.check_scenes();
}

}  // namespace brewster
