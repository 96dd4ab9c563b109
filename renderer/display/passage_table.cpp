#include "display/passage_table.h"

#include <glm/vec2.hpp>

#include "base/units.h"
#include "scene/prepared_material.h"

namespace brewster {
namespace {

constexpr int columns = 256;  // linear interpolation then errs by 2e-5 at most

}  // namespace

PassageTable::PassageTable(const Scene& scene) : texture_(Texture::create()) {
    std::vector<glm::vec2> texels;
    for (const PreparedMaterial& material : prepare_materials(scene.materials)) {
        glm::vec3 share(0.0f), internal(0.0f);
        for (std::size_t band = 0; band < band_count; ++band) {
            for (int x = 0; x < columns; ++x) {
                const float root = static_cast<float>(x) / (columns - 1);
                const Passage<float> passage =
                    material.diffuse() ? material.passage(band, root * root) : Passage<float>{0.0f, 0.0f};
                texels.emplace_back(passage.unpolarized, passage.s_minus_p);
            }
            const float n = material.n[band];
            const auto index = static_cast<int>(band);
            if (material.diffuse()) share[index] = static_cast<float>(1 / pi) / (n * n);
            internal[index] = material.internal_reflectance[band];
        }
        base_shares_.push_back(share);
        internal_reflectances_.push_back(internal);
    }
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, columns, static_cast<GLsizei>(texels.size() / columns), 0, GL_RG, GL_FLOAT,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void PassageTable::bind(const Program& program, const char* uniform, int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    program.set(uniform, unit);
}

}  // namespace brewster
