#include "app/panels/labels.h"

#include <gtest/gtest.h>

#include "display/maps.h"
#include "scene/properties.h"

namespace brewster {
namespace {

TEST(Labels, SettingsAreNamedInWords) {
    EXPECT_EQ(setting_label("rmsHeight", "um"), "rms height, \u00b5m");
    EXPECT_EQ(setting_label("emission", "cd/m2"), "emission, cd/m\u00b2");
    EXPECT_EQ(setting_label("angle", "degrees"), "angle, \u00b0");
    EXPECT_EQ(setting_label("dolp", ""), "DoLP");
    EXPECT_EQ(setting_label("n", ""), "n");
    for (const auto& row : material_properties())
        EXPECT_EQ(setting_label(row.name, row.unit).find("m2"), std::string::npos) << row.name;
}

TEST(Labels, UnitsHaveTheirSigns) {
    EXPECT_EQ(with_unit_signs("0 to 2 cd/m2, 5 um"), "0 to 2 cd/m\u00b2, 5 \u00b5m");
    EXPECT_EQ(with_unit_signs("-90 to 90 degrees"), "-90 to 90\u00b0");
    EXPECT_EQ(with_unit_signs("umber"), "umber");
}

TEST(Labels, MapsAreCalledWhatTheirLegendSaysFirst) {
    EXPECT_EQ(map_label(description(Map::s1).title), "S1");
    EXPECT_EQ(map_label(description(Map::dop).title), "degree of polarization");
    EXPECT_EQ(map_label(description(Map::error).title), "relative standard error");
}

}  // namespace
}  // namespace brewster
