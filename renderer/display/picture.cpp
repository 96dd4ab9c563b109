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

/// Every camera member but its name.
bool same_view(const Camera& a, const Camera& b) {
    return a.position == b.position && a.forward == b.forward && a.up == b.up &&
           a.vertical_field_of_view == b.vertical_field_of_view && a.near_distance == b.near_distance;
}

std::vector<std::string> stokes_defines(bool polarizes) {
    if (!polarizes) return {};
    return {"BREWSTER_STOKES"};
}

std::vector<std::string> chart_defines(TexelStorage storage, bool polarizes) {
    std::vector<std::string> defines = texel_defines(storage);
    for (const std::string& define : stokes_defines(polarizes)) defines.push_back(define);
    return defines;
}

void bind_texture(const Program& program, const char* uniform, int unit, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    program.set(uniform, unit);
}

}  // namespace

Picture::Picture(const Scene& scene, std::size_t largest_buffer_texture)
    : scene_(scene),
      storage_(texel_storage(largest_buffer_texture)),
      upload_(storage_),
      polarizes_(needs_of(scene).stokes > 1),
      materials_(TexelFormat::float4, storage_),
      passages_(scene),
      textures_(scene),
      mesh_(scene),
      chart_program_("chart.vert", "chart.frag", chart_defines(storage_, polarizes_)),
      accumulate_program_("full_screen.vert", "accumulate.frag", stokes_defines(polarizes_)),
      screen_program_("full_screen.vert", "screen.frag"),
      no_vertices_(VertexArray::create()) {
    std::vector<glm::vec4> texels;
    for (const Chart& chart : scene.charts) {
        const Material& material = scene.materials[chart.material];
        texels.emplace_back(material.albedo, 0.0f);
        texels.emplace_back(material.emission, 0.0f);
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
    check_gl("picture of " + scene.name);
}

void Picture::show(std::shared_ptr<const Snapshot> bins) {
    BREWSTER_CHECK(bins && bins->charts.size() == scene_.charts.size(), scene_.name);
    upload_.submit(std::move(bins));
}

bool Picture::upload(std::size_t bytes) {
    const bool other_bins = upload_.advance(bytes);
    if (other_bins) draws_ = 0;
    check_gl("upload of the bins");
    return other_bins;
}

void Picture::look(const Camera& camera, int width, int height) {
    if (width != drawn_.width() || height != drawn_.height()) {
        drawn_ = RenderTarget(width, height, polarizes_ ? 5 : 2, true);
        sums_ = RenderTarget(width, height, polarizes_ ? 6 : 3, false);
        draws_ = 0;
    }
    if (!same_view(camera, camera_)) draws_ = 0;
    camera_ = camera;
}

void Picture::set_polarization(bool on) {
    if (on != polarization_) draws_ = 0;
    polarization_ = on;
}

void Picture::draw(int count) {
    BREWSTER_CHECK(drawn_.width() > 0, "look first");
    for (int i = 0; i < count; ++i) draw_once();
    check_gl("picture of " + scene_.name);
}

void Picture::draw_once() {
    drawn_.bind();
    drawn_.clear();
    if (upload_.drawn()) {
        const glm::vec2 offset = jitter(draws_);
        const float far_distance = 1.01f * (glm::length(camera_.position) + scene_.radius());
        chart_program_.set("view_projection",
                           view_projection(camera_, drawn_.width(), drawn_.height(), offset.x, offset.y, far_distance));
        chart_program_.set("shown_world", upload_.world_offsets(polarization_ ? 0 : 1));
        chart_program_.set("unpolarized", polarization_ ? 0 : 1);
        chart_program_.set("gloss_components", upload_.drawn()->gloss.components);
        chart_program_.set("eye", camera_.position);
        if (polarizes_) chart_program_.set("camera_up", camera_.up);
        upload_.bind(chart_program_, 0);
        materials_.bind(chart_program_, "chart_materials", BinUpload::units);
        passages_.bind(chart_program_, "passages", BinUpload::units + 1);
        for (const ChartGroup& group : mesh_.groups()) {
            textures_.bind(chart_program_, "albedo_texture", BinUpload::units + 2, group.texture);
            mesh_.draw(group);
        }
    }
    sums_.bind();
    if (draws_ == 0) sums_.clear();
    const std::array<const char*, 5> drawn = {"drawn_s0", "drawn_variance", "drawn_s1", "drawn_s2", "drawn_s3"};
    for (int i = 0; i < (polarizes_ ? 5 : 2); ++i)
        bind_texture(accumulate_program_, drawn[static_cast<std::size_t>(i)], i, drawn_.texture(i));
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    ++draws_;
}

Image Picture::stokes() const {
    BREWSTER_CHECK(draws_ > 0, "draw first");
    const std::vector<float> sum = sums_.read(0), squares = sums_.read(1), variances = sums_.read(2);
    check_gl("reading the picture");
    Image image(drawn_.width(), drawn_.height());
    for (int component = 0; component < 4; ++component) {
        for (int band = 0; band < 3; ++band) image.add_channel(stokes_channel(component, band));
    }
    for (int component = 0; component < 4; ++component) {
        for (int band = 0; band < 3; ++band) image.add_channel(variance_channel(component, band));
    }
    const double n = draws_;
    for (int band = 0; band < 3; ++band) {
        std::vector<float>& radiance = image.channel(stokes_channel(0, band));
        std::vector<float>& variance = image.channel(variance_channel(0, band));
        for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
            const std::size_t i = 4 * pixel + static_cast<std::size_t>(band);
            const double mean = static_cast<double>(sum[i]) / n;
            const double spread = draws_ < 2 ? 0 : std::max(0.0, static_cast<double>(squares[i]) / n - mean * mean);
            radiance[pixel] = static_cast<float>(mean);
            variance[pixel] = static_cast<float>(static_cast<double>(variances[i]) / n + spread / std::max(1.0, n - 1));
        }
    }
    for (int component = 1; polarizes_ && component < 4; ++component) {
        const std::vector<float> polarized = sums_.read(2 + component);
        for (int band = 0; band < 3; ++band) {
            std::vector<float>& values = image.channel(stokes_channel(component, band));
            // No component is less certain than the radiance that bears it.
            image.channel(variance_channel(component, band)) = image.channel(variance_channel(0, band));
            for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
                values[pixel] = polarized[4 * pixel + static_cast<std::size_t>(band)] / static_cast<float>(draws_);
        }
    }
    return image;
}

void Picture::finish() const {
    glFinish();
}

float Picture::exposure_of(const Camera& camera) {
    const bool polarization = polarization_;
    set_polarization(false);
    look(camera, 128, 96);
    draws_ = 0;
    draw(4);
    const float exposure = auto_exposure(stokes());
    set_polarization(polarization);
    draws_ = 0;
    return exposure;
}

void Picture::present(const Screen& screen, float exposure) const {
    screen.bind();
    screen.clear();
    if (draws_ == 0) return;
    bind_texture(screen_program_, "sum", 0, sums_.texture(0));
    screen_program_.set("draws", static_cast<float>(draws_));
    screen_program_.set("exposure", exposure);
    screen_program_.set("screen_size", glm::vec2(screen.width(), screen.height()));
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    check_gl("showing the picture");
}

}  // namespace brewster
