#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace brewster {

/// A picture of named float channels, row 0 on top.
/// Stokes pictures name them S0.R .. S3.B, and V0.R .. V3.B for the variance of each.
class Image {
  public:
    Image() = default;
    Image(int width, int height) : width_(width), height_(height) {}

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t pixel_count() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }

    const std::vector<std::string>& channel_names() const { return names_; }
    bool has(const std::string& channel) const;

    /// The channel's pixels; `add_channel` makes one, zero everywhere. An unknown channel is an Error that lists those
    /// there are.
    std::vector<float>& add_channel(const std::string& channel);
    std::vector<float>& channel(const std::string& channel);
    const std::vector<float>& channel(const std::string& channel) const;

    /// String attributes that go into the file's header.
    std::vector<std::pair<std::string, std::string>> attributes;

  private:
    int width_ = 0, height_ = 0;
    std::vector<std::string> names_;
    std::vector<std::vector<float>> pixels_;
};

/// Letters of the bands in channel names.
inline constexpr std::array<char, 3> band_letters = {'R', 'G', 'B'};
/// "S0.R" for (0, 0); "V3.B" is variance_channel(3, 2).
std::string stokes_channel(int component, int band);
std::string variance_channel(int component, int band);
bool is_variance_channel(const std::string& name);

}  // namespace brewster
