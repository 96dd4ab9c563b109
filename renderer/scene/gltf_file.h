#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace brewster {

/// A glTF 2.0 file as it stands in the text, before anything is believed: names are those of the specification,
/// an absent index is -1, and every other index may point anywhere until `validate` has passed.
struct GltfBufferView {
    int buffer = -1;
    std::size_t byte_offset = 0, byte_length = 0, byte_stride = 0;  ///< stride 0: tightly packed
};

/// Elements of an accessor that stand elsewhere.
struct GltfSparse {
    std::size_t count = 0;  ///< 0: the accessor is not sparse
    int indices_view = -1, indices_type = 0, values_view = -1;
    std::size_t indices_offset = 0, values_offset = 0;
};

struct GltfAccessor {
    int buffer_view = -1;  ///< -1: zeros, but for the sparse elements
    std::size_t byte_offset = 0, count = 0;
    int component_type = 0;  ///< 5120 .. 5126
    int components = 0;      ///< numbers an element; 0 for a type that nothing here reads
    bool normalized = false;
    bool is_sparse = false;
    GltfSparse sparse;
};

struct GltfPrimitive {
    std::map<std::string, int> attributes;
    int indices = -1, material = -1, mode = 4;
    bool has_morph_targets = false;
};

struct GltfMesh {
    std::string name;
    std::vector<GltfPrimitive> primitives;
    std::vector<double> weights;  ///< of its morph targets
};

struct GltfSkin {
    int inverse_bind_matrices = -1;
    std::vector<int> joints;
};

struct GltfScene {
    std::string name;
    std::vector<int> nodes;  ///< roots
};

struct GltfImage {
    int buffer_view = -1;
    std::string uri;                   ///< empty where the picture is embedded
    std::vector<unsigned char> bytes;  ///< of a file or a data URI; none: the file is missing
};

struct GltfSampler {
    int mag_filter = -1, min_filter = -1;
    int wrap_s = 10497, wrap_t = 10497;
};

struct GltfTexture {
    int source = -1, sampler = -1;
};

/// Where a material names a texture, with KHR_texture_transform.
struct GltfTextureUse {
    int texture = -1, set = 0;
    std::array<double, 2> offset{0, 0}, scale{1, 1};
    double rotation = 0;  ///< radians

    bool present() const { return texture >= 0; }
};

struct GltfNode {
    std::string name;
    int mesh = -1, camera = -1, light = -1, skin = -1;
    std::vector<int> children;
    std::vector<double> matrix;  ///< column-major, 16 numbers or none
    std::vector<double> translation, rotation, scale;
    std::vector<double> weights;  ///< of its mesh's morph targets; none: the mesh's
};

/// BREWSTER_surface of a material. Lengths in micrometres, angles in degrees.
struct GltfSurface {
    double rms_height = 0, correlation_length = 0;  ///< 0: the file does not say
    std::vector<double> n, k;                       ///< complexIor; none: the file does not say
    bool polarizer = false, retarder = false;
    double angle = 0;                         ///< of the polarizer's passing or the retarder's fast axis
    double retardance = 0;                    ///< the same at every wavelength
    double thickness = 0, birefringence = 0;  ///< of a plate; 0: `retardance` holds
};

struct GltfMaterial {
    std::string name;
    std::vector<double> base_color{1, 1, 1, 1}, emissive{0, 0, 0};
    double metallic = 1, roughness = 1;
    double emissive_strength = 1;  ///< KHR_materials_emissive_strength
    double specular = 1;           ///< KHR_materials_specular, as is the next
    std::vector<double> specular_color{1, 1, 1};
    double ior = 1.5;         ///< KHR_materials_ior
    double transmission = 0;  ///< KHR_materials_transmission
    double thickness = 0;     ///< KHR_materials_volume; 0: a thin wall
    bool attenuates = false;  ///< KHR_materials_volume: its attenuation is other than none
    GltfSurface surface;
    std::string alpha_mode = "OPAQUE";
    double alpha_cutoff = 0.5;
    bool double_sided = false;
    GltfTextureUse base_color_texture, metallic_roughness_texture, emissive_texture;
    GltfTextureUse specular_texture, specular_color_texture, transmission_texture, thickness_texture;
    bool has_normal_texture = false, has_occlusion_texture = false;
    std::vector<std::string> extensions;  ///< all of its extensions
};

struct GltfCamera {
    std::string name, type;
    double vertical_field_of_view = 0, near_distance = 0;
    double aspect_ratio = 0;  ///< 0: the file does not say
};

/// KHR_lights_punctual, and BREWSTER_surface on a light.
struct GltfLight {
    std::string name, type;
    std::vector<double> color{1, 1, 1};
    double intensity = 1, range = 0, inner_cone_angle = 0, outer_cone_angle = 0;
    double dolp = 0, aolp = 0, docp = 0;  ///< polarization, aolp in degrees
    double angular_diameter = 0;          ///< degrees
};

struct GltfFile {
    std::vector<std::vector<unsigned char>> buffers;
    std::vector<GltfBufferView> buffer_views;
    std::vector<GltfAccessor> accessors;
    std::vector<GltfMesh> meshes;
    std::vector<GltfNode> nodes;
    std::vector<GltfMaterial> materials;
    std::vector<GltfCamera> cameras;
    std::vector<GltfLight> lights;
    std::vector<GltfSkin> skins;
    std::vector<GltfImage> images;
    std::vector<GltfSampler> samplers;
    std::vector<GltfTexture> textures;
    std::vector<GltfScene> scenes;
    int scene = -1;
    std::vector<std::string> extensions_used, extensions_required;
    bool has_animations = false;
};

}  // namespace brewster
