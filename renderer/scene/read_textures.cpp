#include "scene/read_textures.h"

#include <algorithm>

namespace brewster {
namespace {

bool is_metal(const GltfMaterial& material) {
    const std::vector<double>& k = material.surface.k;
    return material.metallic >= 0.5 || std::any_of(k.begin(), k.end(), [](double each) { return each > 0; });
}

}  // namespace

GltfMaterial with_texture_means(GltfMaterial material, const std::string& subject, TextureReader& textures,
                                std::vector<std::string>& warnings) {
    if (const SurfaceTexture* texture = textures.read(material.metallic_roughness_texture.texture)) {
        const glm::dvec4 mean = texture_byte_mean(*texture);
        material.roughness *= mean.y;
        material.metallic *= mean.z;
        warnings.push_back(subject + "its metallicRoughnessTexture is not simulated; its mean is");
    }
    if (const SurfaceTexture* texture = textures.read(material.emissive_texture.texture)) {
        const glm::dvec4 mean = texture_mean(*texture);
        for (int band = 0; band < 3; ++band) material.emissive[static_cast<std::size_t>(band)] *= mean[band];
        warnings.push_back(subject + "its emissiveTexture is not simulated; it glows evenly with the mean");
    }
    if (const SurfaceTexture* texture = textures.read(material.transmission_texture.texture)) {
        material.transmission *= texture_byte_mean(*texture).x;
        warnings.push_back(subject + "its transmissionTexture is not simulated; its mean is");
    }
    if (const SurfaceTexture* texture = textures.read(material.thickness_texture.texture))
        material.thickness *= texture_byte_mean(*texture).y;  // whether there is any is all that counts
    if (const SurfaceTexture* texture = textures.read(material.specular_texture.texture)) {
        material.specular *= texture_byte_mean(*texture).w;
        warnings.push_back(subject + "its specularTexture is not simulated; its mean is");
    }
    if (const SurfaceTexture* texture = textures.read(material.specular_color_texture.texture)) {
        const glm::dvec4 mean = texture_mean(*texture);
        for (int band = 0; band < 3; ++band) material.specular_color[static_cast<std::size_t>(band)] *= mean[band];
        warnings.push_back(subject + "its specularColorTexture is not simulated; its mean is");
    }
    if (material.has_normal_texture) warnings.push_back(subject + "its normalTexture is not simulated; it is smooth");
    if (material.has_occlusion_texture)
        warnings.push_back(subject + "its occlusionTexture is not needed: light is traced to every corner");
    const bool uncoloured = is_metal(material) || material.transmission >= 0.5;
    if (!uncoloured || !material.base_color_texture.present()) return material;
    if (const SurfaceTexture* texture = textures.read(material.base_color_texture.texture)) {
        const glm::dvec4 mean = texture_mean(*texture);
        for (int band = 0; band < 3; ++band) material.base_color[static_cast<std::size_t>(band)] *= mean[band];
        if (is_metal(material))
            warnings.push_back(subject + "its baseColorTexture is not simulated on a metal; its mean is");
    }
    return material;
}

void set_texture(Material& material, const GltfMaterial& from, TextureReader& textures) {
    const bool cut_out = from.alpha_mode == "MASK" && from.alpha_cutoff > 0;
    if (cut_out) {
        material.alpha = static_cast<float>(from.base_color[3]);
        material.alpha_cutoff = static_cast<float>(from.alpha_cutoff);
    }
    const bool has_coloured_base = material.base == Base::lambert || material.base == Base::polarized_diffuse;
    if (from.base_color_texture.present() && (cut_out || has_coloured_base))
        material.texture = textures.keep(from.base_color_texture.texture);
}

}  // namespace brewster
