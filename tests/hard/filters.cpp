// Crossed polarizers in front of a sun.
#include <gtest/gtest.h>

#include "hard/hard.h"

namespace brewster {
namespace {

std::string polarizer(double angle) {
    return R"({"extensions": {"BREWSTER_surface": {"polarizer": {"angle": )" + digits(angle) + "}}}}";
}

// The floor lies under two sheets; its surroundings are dark.
SceneFile under_sheets(double angle) {
    SceneFile file;
    const int sheets[2] = {file.material(0, 0, polarizer(0)), file.material(0, 0, polarizer(angle))};
    file.quad("floor", {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, file.material(0));
    for (int k = 0; k < 2; ++k)
        file.quad("sheet " + std::to_string(k), {0, 0.3f + 0.3f * static_cast<float>(k), 1}, {1, 0, 0}, {0, 0, -1},
                  sheets[k]);
    file.sun(1000, {0, -1, 0});
    return file;
}

TEST(Filters, CrossedOnesLeakByRoundingAlone) {
    expect_value(solved(under_sheets(0), 20000).on("floor"), 500, "parallel");
    expect_value(solved(under_sheets(45), 20000).on("floor"), 250, "at 45 degrees");
    const Measured crossed = solved(under_sheets(90), 20000).on("floor");
    std::printf("crossed: %.2g of 1000 lx\n", crossed.mean);
    EXPECT_LT(crossed.mean, 1000 * 0x1p-25);  // half a unit in the last place of a float, of the half that comes
}

}  // namespace
}  // namespace brewster
