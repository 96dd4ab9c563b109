#include "image/stokes_picture.h"

namespace brewster {

StokesPicture::StokesPicture(int width_in_pixels, int height_in_pixels)
    : width(width_in_pixels), height(height_in_pixels) {
    for (std::size_t plane = 0; plane < plane_count; ++plane) {
        light[plane].resize(pixel_count());
        variance[plane].resize(pixel_count());
    }
    difference_variance.resize(pixel_count());
}

StokesPicture stokes_picture(const Image& image) {
    StokesPicture picture(image.width(), image.height());
    const auto fill = [&](std::vector<glm::vec3>& plane, const std::string& channel, int band) {
        if (!image.has(channel)) return;
        const std::vector<float>& values = image.channel(channel);
        for (std::size_t pixel = 0; pixel < plane.size(); ++pixel) plane[pixel][band] = values[pixel];
    };
    for (int band = 0; band < 3; ++band) {
        const std::string plain(1, band_letters[static_cast<std::size_t>(band)]), s0 = stokes_channel(0, band);
        if (!image.has(s0)) image.channel(plain);  // says what there is instead
        fill(picture.of(Plane::s0), image.has(s0) ? s0 : plain, band);
        fill(picture.variance_of(Plane::s0), variance_channel(0, band), band);
        for (const Plane plane : {Plane::s1, Plane::s2, Plane::s3}) {
            fill(picture.of(plane), stokes_channel(static_cast<int>(plane), band), band);
            fill(picture.variance_of(plane), variance_channel(static_cast<int>(plane), band), band);
        }
    }
    picture.of(Plane::unpolarized) = picture.of(Plane::s0);
    picture.variance_of(Plane::unpolarized) = picture.variance_of(Plane::s0);
    return picture;
}

Image stokes_image(const StokesPicture& picture, bool polarization) {
    Image image(picture.width, picture.height);
    const auto fill = [&](std::vector<float>& channel, const std::vector<glm::vec3>& plane, int band) {
        for (std::size_t pixel = 0; pixel < plane.size(); ++pixel) channel[pixel] = plane[pixel][band];
    };
    for (const bool variance : {false, true}) {
        const auto& planes = variance ? picture.variance : picture.light;
        for (int component = 0; component < 4; ++component) {
            for (int band = 0; band < 3; ++band) {
                std::vector<float>& channel =
                    image.add_channel(variance ? variance_channel(component, band) : stokes_channel(component, band));
                if (polarization)
                    fill(channel, planes[static_cast<std::size_t>(component)], band);
                else if (component == 0)
                    fill(channel, planes[static_cast<std::size_t>(Plane::unpolarized)], band);
            }
        }
    }
    return image;
}

}  // namespace brewster
