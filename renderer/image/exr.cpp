#include "image/exr.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/check.h"
#include "base/error.h"

namespace brewster {
namespace {

constexpr std::int64_t largest_side = 32768;             ///< pixels; a header that asks for more is damaged
constexpr std::int64_t largest_value_count = 1LL << 30;  ///< over all channels

/// The slice that sees `pixels` of a picture whose rows have `width` values and whose corner is (x, y).
template <class Value>
Imf::Slice slice_of(Imf::PixelType type, const Value* pixels, int width, int x = 0, int y = 0) {
    const std::size_t row = sizeof(Value) * static_cast<std::size_t>(width);
    return Imf::Slice::Make(type, pixels, IMATH_NAMESPACE::V2i(x, y), width, 0, sizeof(Value), row);
}

/// Pixels as they are stored.
struct Stored {
    Imf::PixelType type = Imf::FLOAT;
    std::vector<half> halves;
    std::vector<float> floats;

    Imf::Slice slice(int width) const {
        return type == Imf::HALF ? slice_of(type, halves.data(), width) : slice_of(type, floats.data(), width);
    }
};

/// The nearest float with five significant bits; zeros at its end cost next to nothing when compressed.
float shortened(float x) {
    constexpr std::uint32_t dropped = (1u << 19) - 1;
    return std::bit_cast<float>((std::bit_cast<std::uint32_t>(x) + (dropped + 1) / 2) & ~dropped);
}

Stored stored(const std::string& name, const std::vector<float>& values, ExrPrecision precision) {
    if (precision == ExrPrecision::single) return {Imf::FLOAT, {}, values};
    if (is_variance_channel(name)) {
        Stored variances{Imf::FLOAT, {}, values};
        std::transform(values.begin(), values.end(), variances.floats.begin(), shortened);
        return variances;
    }
    const auto fits = [](float x) { return std::abs(x) <= static_cast<float>(HALF_MAX); };
    if (!std::all_of(values.begin(), values.end(), fits)) return {Imf::FLOAT, {}, values};
    return {Imf::HALF, {values.begin(), values.end()}, {}};
}

Image read(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imf::Header& header = file.header();
    const IMATH_NAMESPACE::Box2i window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    std::int64_t channels = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) ++channels;
    if (width < 1 || height < 1 || width > largest_side || height > largest_side ||
        width * height * channels > largest_value_count) {
        throw Error("has " + std::to_string(channels) + " channels of " + std::to_string(width) + " x " +
                        std::to_string(height) + " pixels",
                    path, "give a file within 32768 x 32768 pixels and 4 GiB");
    }
    Image image(static_cast<int>(width), static_cast<int>(height));
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1) {
            throw Error(std::string("channel ") + it.name() + " is subsampled", path, "save it at full resolution");
        }
        if (it.channel().type != Imf::UINT) image.add_channel(it.name());
    }
    Imf::FrameBuffer target;
    for (const std::string& name : image.channel_names()) {
        target.insert(name,
                      slice_of(Imf::FLOAT, image.channel(name).data(), image.width(), window.min.x, window.min.y));
    }
    file.setFrameBuffer(target);
    file.readPixels(window.min.y, window.max.y);
    for (auto it = header.begin(); it != header.end(); ++it) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
        if (text) image.attributes.emplace_back(it.name(), text->value());
    }
    return image;
}

}  // namespace

void write_exr(const std::string& path, const Image& image, ExrPrecision precision) {
    BREWSTER_CHECK(image.pixel_count() > 0 && !image.channel_names().empty(), path);
    Imf::Header header(image.width(), image.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, text] : image.attributes) header.insert(name, Imf::StringAttribute(text));
    std::vector<Stored> channels;
    channels.reserve(image.channel_names().size());
    Imf::FrameBuffer source;
    for (const std::string& name : image.channel_names()) {
        const Stored& channel = channels.emplace_back(stored(name, image.channel(name), precision));
        header.channels().insert(name, Imf::Channel(channel.type));
        source.insert(name, channel.slice(image.width()));
    }
    try {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(source);
        file.writePixels(image.height());
    } catch (const std::exception& failure) {
        throw Error(std::string("cannot be written, ") + failure.what(), path,
                    "check that the folder exists, is writable and has room");
    }
}

void write_stokes_exr(const std::string& path, const Image& stokes, ExrPrecision precision) {
    Image described = stokes;
    for (int band = 0; band < 3; ++band) {
        const std::string letter(1, band_letters[static_cast<std::size_t>(band)]);
        if (!described.has(letter)) described.add_channel(letter);
        described.channel(letter) = stokes.channel(stokes_channel(0, band));
    }
    described.attributes.emplace_back("brewster.frame", "x = normalize(cross(ray, up)), receiver");
    described.attributes.emplace_back("brewster.s3", "right circular positive");
    write_exr(path, described, precision);
}

Image read_exr(const std::string& path) {
    try {
        return read(path);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& failure) {
        throw Error(std::string("cannot be read, ") + failure.what(), path, "give the path of an OpenEXR file");
    }
}

}  // namespace brewster
