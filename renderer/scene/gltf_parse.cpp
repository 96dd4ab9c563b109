#include "scene/gltf_parse.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/one_line.h"
#include "scene/gltf_text.h"

namespace brewster {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<unsigned char>;

// What tinygltf may open: files below one folder, links followed first.
struct Folder {
    fs::path path;
    std::string refused;  // the first file outside
};

bool is_below(const fs::path& file, const fs::path& folder) {
    const fs::path relative = fs::weakly_canonical(file).lexically_relative(fs::canonical(folder));
    return !relative.empty() && *relative.begin() != "..";
}

bool file_exists(const std::string& name, void* user) {
    Folder& folder = *static_cast<Folder*>(user);
    std::error_code unreadable;
    if (folder.path.empty() || !fs::is_regular_file(name, unreadable)) return false;
    if (is_below(name, folder.path)) return true;
    if (folder.refused.empty()) folder.refused = name;
    return false;
}

std::string keep_path(const std::string& name, void*) {
    return name;
}

bool read_whole_file(Bytes* bytes, std::string* fault, const std::string& name, void*) {
    std::ifstream stream(name, std::ios::binary);
    bytes->assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    if (stream) return true;
    *fault = "cannot be read";
    return false;
}

bool write_nothing(std::string*, const std::string&, const Bytes&, void*) {
    return false;
}

// Keeps the bytes of pictures in files and data URIs, by index. Those in bufferViews are left alone: nobody has checked
// yet whether the view lies in its buffer.
bool keep_image(tinygltf::Image* image, const int index, std::string*, std::string*, int, int,
                const unsigned char* bytes, int size, void* user) {
    if (image->bufferView < 0)
        (*static_cast<std::map<int, Bytes>*>(user))[index].assign(bytes, bytes + std::max(size, 0));
    return true;
}

// The parser's complaints as part of one sentence; it likes to repeat whole data URIs.
std::string one_sentence(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' ')) text.pop_back();
    constexpr std::size_t longest = 160;
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
}

// The parser wants a property of skins that glTF 2.0 leaves out for identity, but goes on without it.
std::string without_skin_complaints(std::string faults) {
    constexpr std::string_view complaint = "'inverseBindMatrices' property is missing in Skin.\n";
    for (std::size_t at; (at = faults.find(complaint)) != std::string::npos;) faults.erase(at, complaint.size());
    return faults;
}

// The file that a complaint misses; empty for other complaints.
std::string missing_file(const std::string& faults) {
    constexpr std::string_view complaint = "File not found : ";
    const std::size_t at = faults.find(complaint);
    if (at == std::string::npos) return {};
    const std::size_t begin = at + complaint.size();
    return faults.substr(begin, faults.find('\n', begin) - begin);
}

// The JSON chunk of a .glb file: 12 bytes of header, length, "JSON".
std::string_view json_chunk(std::span<const unsigned char> bytes, const std::string& where) {
    std::uint32_t length = 0;
    if (bytes.size() >= 20) std::memcpy(&length, bytes.data() + 12, 4);
    if (length == 0 || length > bytes.size() - 20)
        throw Error("its binary glTF header is broken", where, "export the file again");
    return {reinterpret_cast<const char*>(bytes.data()) + 20, length};
}

int component_count(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        case TINYGLTF_TYPE_MAT4:
            return 16;
        default:
            return 0;  // smaller matrices: nothing that is read here uses them
    }
}

const tinygltf::Value* property(const tinygltf::ExtensionMap& extensions, const std::string& extension,
                                const std::string& name) {
    const auto found = extensions.find(extension);
    if (found == extensions.end() || !found->second.Has(name)) return nullptr;
    return &found->second.Get(name);
}

double number(const tinygltf::ExtensionMap& extensions, const std::string& extension, const std::string& name,
              double absent) {
    const tinygltf::Value* value = property(extensions, extension, name);
    return value ? value->GetNumberAsDouble() : absent;
}

GltfAccessor accessor_of(const tinygltf::Accessor& from) {
    GltfAccessor accessor;
    accessor.buffer_view = from.bufferView;
    accessor.byte_offset = from.byteOffset;
    accessor.count = from.count;
    accessor.component_type = from.componentType;
    accessor.components = component_count(from.type);
    accessor.normalized = from.normalized;
    accessor.is_sparse = from.sparse.isSparse;
    if (accessor.is_sparse)
        accessor.sparse = {static_cast<std::size_t>(from.sparse.count),
                           from.sparse.indices.bufferView,
                           from.sparse.indices.componentType,
                           from.sparse.values.bufferView,
                           static_cast<std::size_t>(from.sparse.indices.byteOffset),
                           static_cast<std::size_t>(from.sparse.values.byteOffset)};
    return accessor;
}

GltfMesh mesh_of(const tinygltf::Mesh& from) {
    GltfMesh mesh{one_line(from.name), {}, from.weights};
    for (const tinygltf::Primitive& primitive : from.primitives)
        mesh.primitives.push_back(
            {primitive.attributes, primitive.indices, primitive.material, primitive.mode, !primitive.targets.empty()});
    return mesh;
}

GltfNode node_of(const tinygltf::Node& from) {
    GltfNode node;
    node.name = one_line(from.name);
    node.mesh = from.mesh;
    node.camera = from.camera;
    node.skin = from.skin;
    node.children = from.children;
    node.matrix = from.matrix;
    node.translation = from.translation;
    node.rotation = from.rotation;
    node.scale = from.scale;
    node.weights = from.weights;
    if (const tinygltf::Value* light = property(from.extensions, "KHR_lights_punctual", "light"))
        node.light = light->GetNumberAsInt();
    return node;
}

double number(const tinygltf::Value& object, const std::string& name, double absent) {
    return object.Has(name) ? object.Get(name).GetNumberAsDouble() : absent;
}

std::vector<double> numbers(const tinygltf::Value& object, const std::string& name) {
    std::vector<double> list;
    if (!object.Has(name)) return list;
    const tinygltf::Value& from = object.Get(name);
    for (std::size_t i = 0; i < from.ArrayLen(); ++i) list.push_back(from.Get(static_cast<int>(i)).GetNumberAsDouble());
    return list;
}

GltfSurface surface_of(const tinygltf::ExtensionMap& extensions) {
    GltfSurface surface;
    const auto found = extensions.find("BREWSTER_surface");
    if (found == extensions.end()) return surface;
    const tinygltf::Value& from = found->second;
    surface.rms_height = number(from, "rmsHeight", 0);
    surface.correlation_length = number(from, "correlationLength", 0);
    if (from.Has("complexIor")) {
        surface.n = numbers(from.Get("complexIor"), "n");
        surface.k = numbers(from.Get("complexIor"), "k");
    }
    surface.polarizer = from.Has("polarizer");
    surface.retarder = from.Has("retarder");
    if (surface.polarizer) surface.angle = number(from.Get("polarizer"), "angle", 0);
    if (surface.retarder) {
        const tinygltf::Value& plate = from.Get("retarder");
        surface.angle = number(plate, "angle", 0);
        surface.retardance = number(plate, "retardance", 0);
        surface.thickness = number(plate, "thickness", 0);
        surface.birefringence = number(plate, "birefringence", 0);
    }
    return surface;
}

// KHR_materials_volume: a distance without a colour, or a white colour, attenuates nothing.
bool attenuates(const tinygltf::ExtensionMap& extensions) {
    const tinygltf::Value* colour = property(extensions, "KHR_materials_volume", "attenuationColor");
    if (!colour || !property(extensions, "KHR_materials_volume", "attenuationDistance")) return false;
    for (int band = 0; band < 3; ++band)
        if (colour->Get(band).GetNumberAsDouble() < 1.0) return true;
    return false;
}

GltfTextureUse use_of(const tinygltf::TextureInfo& from) {
    GltfTextureUse use{from.index, from.texCoord};
    const auto found = from.extensions.find("KHR_texture_transform");
    if (found == from.extensions.end()) return use;
    const auto pair = [&](const char* name, std::array<double, 2>& into) {
        const std::vector<double> values = numbers(found->second, name);
        if (values.size() == 2) into = {values[0], values[1]};
    };
    pair("offset", use.offset);
    pair("scale", use.scale);
    use.rotation = number(found->second, "rotation", 0);
    use.set = static_cast<int>(number(found->second, "texCoord", use.set));
    return use;
}

// A texture of a material's extension; only its mean is looked at, so where it lies does not matter.
GltfTextureUse use_of(const tinygltf::ExtensionMap& extensions, const std::string& extension, const std::string& name) {
    const tinygltf::Value* texture = property(extensions, extension, name);
    GltfTextureUse use;
    if (texture) use.texture = static_cast<int>(number(*texture, "index", -1));
    return use;
}

GltfMaterial material_of(const tinygltf::Material& from) {
    GltfMaterial material;
    material.name = one_line(from.name);
    material.base_color = from.pbrMetallicRoughness.baseColorFactor;
    if (!from.emissiveFactor.empty()) material.emissive = from.emissiveFactor;
    material.metallic = from.pbrMetallicRoughness.metallicFactor;
    material.roughness = from.pbrMetallicRoughness.roughnessFactor;
    material.emissive_strength =
        number(from.extensions, "KHR_materials_emissive_strength", "emissiveStrength", material.emissive_strength);
    material.specular = number(from.extensions, "KHR_materials_specular", "specularFactor", material.specular);
    if (property(from.extensions, "KHR_materials_specular", "specularColorFactor"))
        material.specular_color = numbers(from.extensions.at("KHR_materials_specular"), "specularColorFactor");
    material.specular_texture = use_of(from.extensions, "KHR_materials_specular", "specularTexture");
    material.specular_color_texture = use_of(from.extensions, "KHR_materials_specular", "specularColorTexture");
    material.transmission_texture = use_of(from.extensions, "KHR_materials_transmission", "transmissionTexture");
    material.thickness_texture = use_of(from.extensions, "KHR_materials_volume", "thicknessTexture");
    material.ior = number(from.extensions, "KHR_materials_ior", "ior", material.ior);
    material.transmission =
        number(from.extensions, "KHR_materials_transmission", "transmissionFactor", material.transmission);
    material.thickness = number(from.extensions, "KHR_materials_volume", "thicknessFactor", material.thickness);
    material.attenuates = attenuates(from.extensions);
    material.surface = surface_of(from.extensions);
    material.alpha_mode = from.alphaMode;
    material.double_sided = from.doubleSided;
    material.alpha_cutoff = from.alphaCutoff;
    material.base_color_texture = use_of(from.pbrMetallicRoughness.baseColorTexture);
    material.metallic_roughness_texture = use_of(from.pbrMetallicRoughness.metallicRoughnessTexture);
    material.emissive_texture = use_of(from.emissiveTexture);
    material.has_normal_texture = from.normalTexture.index >= 0;
    material.has_occlusion_texture = from.occlusionTexture.index >= 0;
    for (const auto& [name, value] : from.extensions) material.extensions.push_back(name);
    return material;
}

GltfLight light_of(const tinygltf::Light& from) {
    GltfLight light{one_line(from.name), from.type, from.color, from.intensity, from.range, 0, 0};
    if (light.color.empty()) light.color = {1, 1, 1};
    light.inner_cone_angle = from.spot.innerConeAngle;
    light.outer_cone_angle = from.spot.outerConeAngle;
    const auto found = from.extensions.find("BREWSTER_surface");
    if (found == from.extensions.end()) return light;
    light.angular_diameter = number(found->second, "angularDiameter", 0);
    if (!found->second.Has("polarization")) return light;
    const tinygltf::Value& polarization = found->second.Get("polarization");
    light.dolp = number(polarization, "dolp", 0);
    light.aolp = number(polarization, "aolp", 0);
    light.docp = number(polarization, "docp", 0);
    return light;
}

GltfFile file_of(tinygltf::Model&& from, std::map<int, Bytes>&& pictures) {
    GltfFile file;
    for (tinygltf::Buffer& buffer : from.buffers) file.buffers.push_back(std::move(buffer.data));
    for (const tinygltf::BufferView& view : from.bufferViews)
        file.buffer_views.push_back({view.buffer, view.byteOffset, view.byteLength, view.byteStride});
    for (const tinygltf::Accessor& accessor : from.accessors) file.accessors.push_back(accessor_of(accessor));
    for (const tinygltf::Mesh& mesh : from.meshes) file.meshes.push_back(mesh_of(mesh));
    for (const tinygltf::Node& node : from.nodes) file.nodes.push_back(node_of(node));
    for (const tinygltf::Material& material : from.materials) file.materials.push_back(material_of(material));
    for (const tinygltf::Camera& camera : from.cameras)
        file.cameras.push_back({one_line(camera.name), camera.type, camera.perspective.yfov, camera.perspective.znear,
                                camera.perspective.aspectRatio});
    for (const tinygltf::Light& light : from.lights) file.lights.push_back(light_of(light));
    for (const tinygltf::Skin& skin : from.skins) file.skins.push_back({skin.inverseBindMatrices, skin.joints});
    for (const tinygltf::Image& image : from.images)
        file.images.push_back(
            {image.bufferView, one_line(image.uri), std::move(pictures[static_cast<int>(file.images.size())])});
    for (const tinygltf::Sampler& sampler : from.samplers)
        file.samplers.push_back({sampler.magFilter, sampler.minFilter, sampler.wrapS, sampler.wrapT});
    for (const tinygltf::Texture& texture : from.textures) file.textures.push_back({texture.source, texture.sampler});
    for (const tinygltf::Scene& scene : from.scenes) file.scenes.push_back({one_line(scene.name), scene.nodes});
    file.scene = from.defaultScene;
    file.extensions_used = from.extensionsUsed;
    file.extensions_required = from.extensionsRequired;
    file.has_animations = !from.animations.empty();
    return file;
}

}  // namespace

GltfFile parse_gltf(std::span<const unsigned char> bytes, const fs::path& folder, const std::string& where) {
    const bool binary = bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
    if (bytes.size() > std::numeric_limits<unsigned>::max())
        throw Error("it is larger than 4 GB", where, "split it, or keep its buffers in files of their own");
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    check_gltf_text(binary ? json_chunk(bytes, where) : std::string_view(text, bytes.size()), where);

    Folder allowed{folder, {}};
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks({file_exists, keep_path, read_whole_file, write_nothing, &allowed});
    std::map<int, Bytes> pictures;
    parser.SetImageLoader(keep_image, &pictures);
    tinygltf::Model model;
    std::string faults, remarks;
    bool parsed = false;
    try {
        const auto size = static_cast<unsigned>(bytes.size());
        parsed = binary ? parser.LoadBinaryFromMemory(&model, &faults, &remarks, bytes.data(), size, folder.string())
                        : parser.LoadASCIIFromString(&model, &faults, &remarks, text, size, folder.string());
    } catch (const std::exception& fault) {
        faults += fault.what();
    }
    faults = without_skin_complaints(std::move(faults));
    if (!allowed.refused.empty())
        throw Error("it names \"" + allowed.refused + "\", which is not below its own folder", where,
                    "move that file beside it");
    if (const std::string missing = missing_file(faults); !missing.empty())
        throw Error("the file \"" + missing + "\" that it names is missing", where,
                    "put it where the scene expects it");
    // Some faults only shorten a list in the parser's eyes, so any complaint counts.
    if (!parsed || !faults.empty())
        throw Error("it is not valid glTF 2.0 (" + one_sentence(faults) + ")", where, "export the file again");
    return file_of(std::move(model), std::move(pictures));
}

}  // namespace brewster
