#include "transport/scalar/path_class_flux.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "base/error.h"
#include "bench.h"
#include "engine/slow.h"
#include "rooms.h"

namespace brewster {
namespace {

constexpr KernelChoice polarized_bands{4, 3, false};

std::uint64_t photons() {
    const char* wish = std::getenv("BREWSTER_PATH_PHOTONS");
    return wish ? static_cast<std::uint64_t>(std::strtod(wish, nullptr)) : slow ? 200000 : 1000000;
}

// Figure 8.1 of the thesis (theory 2.7, 3.9): sun -> floor -> side -> back wall, on over off, both interfaces of slope m.
// Bounds: the published spread of the expected numbers, and four standard errors of the run.
TEST(PathClassFlux, FigureOfTheThesis) {
    struct Row {
        float slope;
        double expected, slack;
    };
    for (const Row& row : {Row{0.04f, 0.065, 0.003}, Row{0.01f, 0.0057, 0.0005}, Row{0.0f, 0.00020, 0.00002}}) {
        Scene scene = *rooms::read("brewster-room.gltf");
        for (Material& material : scene.materials)
            if (material.interface.present()) {
                material.interface.slope = row.slope;
                material.interface.finish = row.slope > 0 ? Finish::beckmann : Finish::smooth;
            }
        Bench bench(scene, 1, polarized_bands);
        const PathClassFlux flux = path_class_flux(bench.context, {"floor", "cuboid side", "back wall"}, photons());
        std::printf("figure 8.1, m = %.2f: on/off %.4f %% +- %.4f %%, off %.4g of the photons' weight\n",
                    static_cast<double>(row.slope), 100 * flux.ratio, 100 * flux.ratio_standard_error,
                    flux.unpolarized[1]);
        EXPECT_GT(flux.unpolarized[0], 0);
        EXPECT_NEAR(flux.ratio, row.expected, row.slack + 4 * flux.ratio_standard_error);
    }
}

// Light that meets one interface only is not less by its polarization.
TEST(PathClassFlux, OneReflectionCannotTellPolarizationsApart) {
    const auto scene = rooms::read("brewster-room.gltf");
    Bench bench(*scene, 1, polarized_bands);
    const PathClassFlux flux = path_class_flux(bench.context, {"floor", "back wall"}, 200000);
    EXPECT_NEAR(flux.ratio, 1, 1e-6);
    EXPECT_THROW(path_class_flux(bench.context, {"no such wall"}, 1), Error);
}

}  // namespace
}  // namespace brewster
