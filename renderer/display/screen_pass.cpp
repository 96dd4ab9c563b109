#include "display/screen_pass.h"

#include "display/gl_context.h"

namespace brewster {

namespace {

/// Of the texture that is bound.
bool is_stretched(const Screen& screen) {
    GLint width = 0, height = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
    return width != screen.width() || height != screen.height();
}

}  // namespace

ScreenPass::ScreenPass() : no_vertices_(VertexArray::create()), black_(Texture::create()) {
    constexpr float black[4] = {0, 0, 0, 0};
    glBindTexture(GL_TEXTURE_2D, black_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, black);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    check_gl("preparing to show pictures");
}

const Program& ScreenPass::program(Map map, bool analyzed, bool stretched) const {
    const std::tuple key(map, analyzed, stretched);
    if (const auto known = programs_.find(key); known != programs_.end()) return known->second;
    std::vector<std::string> defines = {"BREWSTER_MAP " + std::to_string(static_cast<int>(map))};
    if (analyzed) defines.emplace_back("BREWSTER_ANALYZER");
    if (stretched) defines.emplace_back("BREWSTER_STRETCHED");
    return programs_.try_emplace(key, "full_screen.vert", "screen.frag", defines).first->second;
}

void ScreenPass::show(const Screen& screen, const LightTextures& light, const Rendition& rendition, bool over) const {
    const bool cells = rendition.map == Map::bins;
    const LightTextures::World& world = rendition.shows_polarized_world() ? light.polarized : light.unpolarized;
    const auto or_black = [&](GLuint texture) { return texture != 0 ? texture : black_.id(); };
    const GLuint s0 = or_black(cells ? light.cells : world.s0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, s0);
    const glm::vec4 analyzer = rendition.analyzer.passing();
    const Program& shown = program(rendition.map, analyzer.w != 0, is_stretched(screen));
    const auto set = [&](const char* uniform, const auto& value) {
        if (shown.has(uniform)) shown.set(uniform, value);
    };
    int unit = 0;
    const auto bind = [&](const char* uniform, GLuint texture) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, or_black(texture));
        set(uniform, unit++);
    };
    bind("light_s0", s0);
    bind("light_s1", world.s1);
    bind("light_s2", world.s2);
    bind("light_s3", world.s3);
    bind("light_unpolarized", light.unpolarized.s0);
    bind("variance_s0", world.variance_s0);
    bind("variance_linear", world.variance_linear);
    bind("variance_s3", world.variance_s3);
    bind("squares_s0", world.squares_s0);
    set("has_squares", world.squares_s0 != 0 ? 1 : 0);
    set("over", over ? 1 : 0);
    set("palette", static_cast<int>(rendition.palette));
    set("analyzer", analyzer);
    set("exposure", rendition.exposure);
    set("screen_size", glm::vec2(screen.width(), screen.height()));
    screen.bind();
    if (!over) screen.clear();
    shown.use();
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    check_gl("showing the picture");
}

}  // namespace brewster
