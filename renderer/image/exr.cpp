#include "image/exr.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

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

std::vector<half> rounded(const std::vector<float>& values) {
    return {values.begin(), values.end()};
}

Imf::Header header_of(const Image& image, ExrPrecision precision) {
    Imf::Header header(image.width(), image.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, text] : image.attributes) header.insert(name, Imf::StringAttribute(text));
    for (const std::string& name : image.channel_names()) {
        header.channels().insert(name, Imf::Channel(precision == ExrPrecision::half ? Imf::HALF : Imf::FLOAT));
    }
    return header;
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
    std::vector<std::vector<half>> halves;
    halves.reserve(image.channel_names().size());
    Imf::FrameBuffer source;
    for (const std::string& name : image.channel_names()) {
        const std::vector<float>& values = image.channel(name);
        if (precision == ExrPrecision::single) {
            source.insert(name, slice_of(Imf::FLOAT, values.data(), image.width()));
        } else {
            source.insert(name, slice_of(Imf::HALF, halves.emplace_back(rounded(values)).data(), image.width()));
        }
    }
    try {
        Imf::OutputFile file(path.c_str(), header_of(image, precision));
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
