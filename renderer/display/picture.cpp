#include "display/picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "base/check.h"
#include "display/gl_context.h"
#include "display/tone.h"
#include "scene/needs.h"

namespace brewster {
namespace {

/// Radical inverse in base 2 of an index below 2^24, exact in float.
float van_der_corput(std::uint32_t index) {
    std::uint32_t bits = 0;
    for (std::uint32_t digit = 1u << 31; index != 0; index >>= 1, digit >>= 1) bits |= (index & 1) * digit;
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// The second dimension of the Sobol sequence (Kollig and Keller 2002, "Efficient multidimensional sampling").
float sobol_2(std::uint32_t index) {
    std::uint32_t bits = 0;
    for (std::uint32_t direction = 1u << 31; index != 0; index >>= 1, direction ^= direction >> 1) {
        bits ^= (index & 1) * direction;
    }
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// Where draw `index` looks through the pixels, from their centres: in [-0.5, 0.5)^2. All pixels share it, so that
/// errors of a straight edge do not average out along it; hence each 64 draws are a (0,2)-net whose projections are the
/// middles of 64 equal parts, and edges along the pixels are off by 1/128 at most. Further 64s are shifted within these
/// parts.
glm::vec2 jitter(int index) {
    const auto point = static_cast<std::uint32_t>(index);
    const float shift = 0.5f + van_der_corput(point / 64 + 1) / 64;
    const float x = van_der_corput(point % 64) + shift, y = sobol_2(point % 64) + shift;
    return {x - std::floor(x) - 0.5f, y - std::floor(y) - 0.5f};
}

}  // namespace

Picture::Picture(const Scene& scene, std::size_t largest_buffer_texture)
    : scene_(&scene),
      storage_(texel_storage(largest_buffer_texture)),
      upload_(storage_),
      polarizes_(needs_of(scene).stokes > 1),
      materials_(TexelFormat::float4, storage_),
      passages_(scene),
      textures_(scene),
      mesh_(scene) {
    write_materials();
    check_gl("picture of " + scene.name);
}

void Picture::write_materials() {
    std::vector<glm::vec4> texels;
    for (const Chart& chart : scene_->charts) {
        const Material& material = scene_->materials[chart.material];
        texels.emplace_back(material.albedo, 0.0f);
        texels.emplace_back(material.emission, material.beyond_bins() ? 1.0f : 0.0f);
        const bool coloured = material.base == Base::lambert || material.base == Base::polarized_diffuse;
        // Transparent surfaces are left out by a cutoff that nothing reaches: bins hold nothing of them.
        const float cutoff = material.base == Base::transparent ? 2.0f : material.alpha_cutoff;
        texels.emplace_back(coloured ? 1.0f : 0.0f, material.alpha, cutoff, static_cast<float>(chart.material));
        texels.emplace_back(passages_.internal_reflectances()[chart.material], 0.0f);
        texels.emplace_back(passages_.base_shares()[chart.material], 0.0f);
        texels.emplace_back(chart.axis_u, 0.0f);
        texels.emplace_back(chart.axis_v, 0.0f);
    }
    materials_.reserve(texels.size());
    materials_.write(0, texels.size(), texels.data());
}

void Picture::repaint(const Scene& scene) {
    BREWSTER_CHECK(scene.charts.size() == scene_->charts.size(), scene.name);
    scene_ = &scene;
    passages_ = PassageTable(scene);
    const bool polarizes = needs_of(scene).stokes > 1;
    if (polarizes != polarizes_) layers_ = {};
    polarizes_ = polarizes;
    write_materials();
    forget();
    check_gl("picture of " + scene.name);
}

void Picture::show(std::shared_ptr<const Snapshot> bins) {
    BREWSTER_CHECK(bins && bins->charts.size() == scene_->charts.size(), scene_->name);
    upload_.submit(std::move(bins));
}

bool Picture::upload(std::size_t bytes) {
    const bool other_bins = upload_.advance(bytes);
    if (other_bins) forget();
    check_gl("upload of the bins");
    return other_bins;
}

void Picture::look(const Camera& camera, int width, int height) {
    if (!same_pose(camera, camera_) || camera.near_distance != camera_.near_distance) forget();
    camera_ = camera;
    width_ = width;
    height_ = height;
    for (const Part part : {polarized, unpolarized, cells})
        if (layers_[part]) layers_[part]->resize(width, height);
    if (!layers_[polarized]) layer(polarized);
}

void Picture::forget() {
    for (std::optional<Layer>& made : layers_)
        if (made) made->forget();
}

void Picture::show_glimpse(int width, int height, const std::vector<std::uint32_t>& chart,
                           const std::array<std::vector<glm::vec3>, plane_count>& light) {
    glimpse_.upload(width, height, chart, light);
    forget();
}

void Picture::clear_glimpse() {
    if (!glimpse_.shows()) return;
    glimpse_.clear();
    forget();
}

Layer& Picture::layer(Part part) {
    std::optional<Layer>& made = layers_[part];
    if (!made) {
        const LayerKind kind = part == cells                     ? LayerKind::cells
                               : part == polarized && polarizes_ ? LayerKind::stokes
                                                                 : LayerKind::radiance;
        made.emplace(kind, texel_defines(storage_));
    }
    made->resize(width_, height_);
    return *made;
}

const Layer* Picture::drawn_layer(Part part) const {
    const std::optional<Layer>& made = layers_[place_of(part)];
    return made && made->draws() > 0 ? &*made : nullptr;
}

std::array<bool, 3> Picture::parts_of(const Rendition& rendition) const {
    if (rendition.map == Map::bins) return {false, false, true};
    if (!polarizes_) return {true, false, false};
    return {rendition.shows_polarized_world(), rendition.shows_unpolarized_world(), false};
}

void Picture::draw(int count, const Rendition& rendition) {
    BREWSTER_CHECK(width_ > 0, "look first");
    const std::array<bool, 3> wanted = parts_of(rendition);
    const int aim = draws(rendition) + count;
    for (const Part part : {polarized, unpolarized, cells})
        if (wanted[part])
            while (layer(part).draws() < aim) draw_part(part, 1);
    check_gl("picture of " + scene_->name);
}

void Picture::draw_band(int bands, const Rendition& rendition) {
    BREWSTER_CHECK(width_ > 0 && bands > 0, "look first");
    const std::array<bool, 3> wanted = parts_of(rendition);
    const int aim = draws(rendition) + 1;
    for (const Part part : {polarized, unpolarized, cells})
        if (wanted[part] && layer(part).draws() < aim) {
            draw_part(part, bands);
            break;
        }
    check_gl("picture of " + scene_->name);
}

int Picture::draws(const Rendition& rendition) const {
    const std::array<bool, 3> wanted = parts_of(rendition);
    int least = std::numeric_limits<int>::max();
    for (const Part part : {polarized, unpolarized, cells})
        if (wanted[part]) least = std::min(least, layers_[part] ? layers_[part]->draws() : 0);
    return least;
}

void Picture::draw_part(Part part, int bands) {
    Layer& target = layer(part);
    const auto charts = [&](const Program& program) {
        if (upload_.drawn()) draw_charts(program, part, target.draws());
    };
    if (bands == 1)
        target.add(charts);
    else
        target.add_band(charts, bands);
}

void Picture::draw_charts(const Program& program, Part part, int index) const {
    const glm::vec2 offset = jitter(index);
    const float far_distance = 1.01f * (glm::length(camera_.position) + scene_->radius());
    program.set("view_projection", view_projection(camera_, width_, height_, offset.x, offset.y, far_distance));
    program.set("eye", camera_.position);
    if (part != cells) {  // which have neither world nor light
        program.set("gloss_components", upload_.drawn()->gloss.components);
        program.set("shown_world", upload_.world_offsets(part == unpolarized ? 1 : 0));
        program.set("flat_light", flat_ ? 1 : 0);
        program.set("unpolarized", part == unpolarized ? 1 : 0);
        passages_.bind(program, "passages", BinUpload::units + 1);
    }
    if (part != cells) glimpse_.bind(program, BinUpload::units + 3, width_, height_);
    if (program.has("camera_up")) program.set("camera_up", camera_.up);
    upload_.bind(program, 0);
    materials_.bind(program, "chart_materials", BinUpload::units);
    for (const ChartGroup& group : mesh_.groups()) {
        textures_.bind(program, "albedo_texture", BinUpload::units + 2, group.texture);
        mesh_.draw(group);
    }
}

LightTextures Picture::light() const {
    LightTextures textures;
    const auto world_of = [&](Part part) {
        LightTextures::World world;
        const Layer* drawn = drawn_layer(part);
        if (!drawn) return world;
        world.s0 = drawn->texture(Layer::s0);
        world.variance_s0 = drawn->texture(Layer::variance_s0);
        world.squares_s0 = drawn->texture(Layer::squares_s0);
        if (drawn->kind() == LayerKind::radiance) return world;
        world.s1 = drawn->texture(Layer::s1);
        world.s2 = drawn->texture(Layer::s2);
        world.s3 = drawn->texture(Layer::s3);
        world.variance_linear = drawn->texture(Layer::variance_linear);
        world.variance_s3 = drawn->texture(Layer::variance_s3);
        return world;
    };
    textures.polarized = world_of(polarized);
    textures.unpolarized = world_of(unpolarized);
    if (const Layer* drawn = drawn_layer(cells)) textures.cells = drawn->texture(Layer::s0);
    return textures;
}

Image Picture::stokes(bool polarization) const {
    const Layer* drawn = drawn_layer(polarization ? polarized : unpolarized);
    BREWSTER_CHECK(drawn != nullptr, "draw first");
    return drawn->stokes();
}

void Picture::make_flat(bool flat) {
    flat_ = flat;
    forget();
}

void Picture::finish() const {
    glFinish();
}

float Picture::exposure_of(const Camera& camera) {
    const Part part = place_of(unpolarized);
    Layer::Drawing kept = layer(part).exchange({});
    GlimpseLight kept_glimpse = std::exchange(glimpse_, {});  // which is of another view
    const Camera kept_camera = std::exchange(camera_, camera);
    const int kept_width = std::exchange(width_, 128), kept_height = std::exchange(height_, 96);
    for (int i = 0; i < 4; ++i) draw_part(part, 1);
    const float exposure = auto_exposure(stokes(false));
    layers_[part]->exchange(std::move(kept));
    glimpse_ = std::move(kept_glimpse);
    camera_ = kept_camera;
    width_ = kept_width;
    height_ = kept_height;
    return exposure;
}

}  // namespace brewster
