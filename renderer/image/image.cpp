#include "image/image.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"

namespace brewster {
namespace {

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : " ") + name;
    return list.empty() ? "no channel at all" : list;
}

std::size_t index_of(const std::vector<std::string>& names, const std::string& channel) {
    const auto found = std::find(names.begin(), names.end(), channel);
    if (found == names.end()) {
        throw Error("the picture has no channel " + channel, "picture", "it holds " + listed(names));
    }
    return static_cast<std::size_t>(found - names.begin());
}

std::string channel_name(char quantity, int component, int band) {
    BREWSTER_CHECK(component >= 0 && component < 4 && band >= 0 && band < 3, std::to_string(component));
    return {quantity, static_cast<char>('0' + component), '.', band_letters[static_cast<std::size_t>(band)]};
}

}  // namespace

bool Image::has(const std::string& channel) const {
    return std::find(names_.begin(), names_.end(), channel) != names_.end();
}

std::vector<float>& Image::add_channel(const std::string& channel) {
    BREWSTER_CHECK(!has(channel), channel);
    names_.push_back(channel);
    return pixels_.emplace_back(pixel_count(), 0.0f);
}

std::vector<float>& Image::channel(const std::string& channel) {
    return pixels_[index_of(names_, channel)];
}

const std::vector<float>& Image::channel(const std::string& channel) const {
    return pixels_[index_of(names_, channel)];
}

std::string stokes_channel(int component, int band) {
    return channel_name('S', component, band);
}

std::string variance_channel(int component, int band) {
    return channel_name('V', component, band);
}

bool is_variance_channel(const std::string& name) {
    return name.size() == 4 && name[0] == 'V' && name[2] == '.';
}

}  // namespace brewster
