#include "display/screen_pass.h"

#include "display/gl_context.h"

namespace brewster {

ScreenPass::ScreenPass()
    : program_("full_screen.vert", "screen.frag"), no_vertices_(VertexArray::create()), black_(Texture::create()) {
    constexpr float black[4] = {0, 0, 0, 0};
    glBindTexture(GL_TEXTURE_2D, black_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, black);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    check_gl("preparing to show pictures");
}

void ScreenPass::show(const Screen& screen, const LightTextures& light, const Rendition& rendition) const {
    int unit = 0;
    const auto bind = [&](const char* uniform, GLuint texture) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, texture != 0 ? texture : black_.id());
        program_.set(uniform, unit++);
    };
    const bool cells = rendition.map == Map::bins;
    const LightTextures::World& world = rendition.shows_polarized_world() ? light.polarized : light.unpolarized;
    bind("light_s0", cells ? light.cells : world.s0);
    bind("light_s1", world.s1);
    bind("light_s2", world.s2);
    bind("light_s3", world.s3);
    bind("light_unpolarized", light.unpolarized.s0);
    bind("variance_s0", world.variance_s0);
    bind("variance_linear", world.variance_linear);
    bind("variance_s3", world.variance_s3);
    bind("squares_s0", world.squares_s0);
    program_.set("has_squares", world.squares_s0 != 0 ? 1 : 0);
    program_.set("draws", cells ? light.cells_draws : world.draws);
    program_.set("unpolarized_draws", light.unpolarized.draws);
    program_.set("map", static_cast<int>(rendition.map));
    program_.set("palette", static_cast<int>(rendition.palette));
    program_.set("analyzer", rendition.analyzer.passing());
    program_.set("exposure", rendition.exposure);
    program_.set("screen_size", glm::vec2(screen.width(), screen.height()));
    screen.bind();
    screen.clear();
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    check_gl("showing the picture");
}

}  // namespace brewster
