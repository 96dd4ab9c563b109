// 4096 pixels of a large picture, always the same ones, as a picture of 64 x 64: a truth that is good enough for a
// megapixel would take hours.
//   bench_pixels trace SCENE CAMERA WIDTHxHEIGHT PATHS OUT.exr   follows so many camera paths through each of them
//   bench_pixels pick PICTURE.exr OUT.exr                        takes them out of a picture of that size
// `brewster compare` compares what the two write. (Camera paths alone: not for scenes with point lamps or a sun.)
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <random>

#include "base/error.h"
#include "base/threads.h"
#include "image/exr.h"
#include "reference/camera_tracer.h"

namespace {

using namespace brewster;

constexpr int side = 64;

struct Pixel {
    int column, row;
};

std::vector<Pixel> chosen(int width, int height) {
    std::mt19937 random(1997);
    std::vector<Pixel> pixels(side * side);
    for (Pixel& pixel : pixels) {
        pixel.column = static_cast<int>(random() % static_cast<unsigned>(width));
        pixel.row = static_cast<int>(random() % static_cast<unsigned>(height));
    }
    return pixels;
}

Image traced(const std::string& path, const std::string& camera, int width, int height, std::uint64_t paths) {
    const Scene scene = read_scene(path);
    const Surroundings surroundings(scene);
    const CameraTracer tracer(surroundings, scene.camera(camera), width, height,
                              {true, camera_tracer_owns | PathClass::caustics, 4096});
    const std::vector<Pixel> pixels = chosen(width, height);
    StokesSums sums(side, side);
    on_threads(side, 2, [&](int row, unsigned) {
        for (std::size_t k = 0; k < side; ++k) {
            const std::size_t i = static_cast<std::size_t>(row) * side + k;
            for (std::uint64_t index = 0; index < paths; ++index)
                sums.add(i, tracer.sample(pixels[i].column, pixels[i].row, index));
        }
    });
    Image image(side, side);
    sums.add_to(image, paths);
    return image;
}

Image picked(const Image& picture) {
    const std::vector<Pixel> pixels = chosen(picture.width(), picture.height());
    Image image(side, side);
    for (const std::string& name : picture.channel_names()) {
        const std::vector<float>& from = picture.channel(name);
        std::vector<float>& to = image.add_channel(name);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            to[i] = from[static_cast<std::size_t>(pixels[i].row) * static_cast<std::size_t>(picture.width()) +
                         static_cast<std::size_t>(pixels[i].column)];
    }
    return image;
}

}  // namespace

int main(int count, char** arguments) try {
    const std::vector<std::string> words(arguments + 1, arguments + count);
    int width = 0, height = 0;
    if (words.size() == 6 && words[0] == "trace" && std::sscanf(words[3].c_str(), "%dx%d", &width, &height) == 2) {
        const auto paths = static_cast<std::uint64_t>(std::atof(words[4].c_str()));
        write_stokes_exr(words[5], traced(words[1], words[2], width, height, paths));
    } else if (words.size() == 3 && words[0] == "pick") {
        write_stokes_exr(words[2], picked(read_exr(words[1])));
    } else {
        std::cerr << "bench_pixels trace SCENE CAMERA WIDTHxHEIGHT PATHS OUT.exr, or pick PICTURE.exr OUT.exr\n";
        return 2;
    }
    return 0;
} catch (const brewster::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
}
