#include "reference/path_class.h"

#include <gtest/gtest.h>

#include <vector>

namespace brewster {
namespace {

/// Every sequence of up to five events, from the camera to the lamp: both walks agree where both can go, the owners
/// share nothing, and what can no longer end in a set does not.
TEST(PathClass, BothTracersAgreeAndOwnersAreDisjoint) {
    EXPECT_EQ(camera_tracer_owns & light_tracer_owns, 0u);
    const Event events[] = {Event::base, Event::gloss, Event::sharp, Event::straight};
    for (int length = 1; length <= 5; ++length) {
        for (int code = 0; code < 1 << (2 * length); ++code) {
            std::vector<Event> path;
            for (int j = 0; j < length; ++j) path.push_back(events[code >> (2 * j) & 3]);
            EyePathClass eye;
            std::vector<EyePathClass> prefixes;
            for (const Event event : path) {
                eye.add(event);
                prefixes.push_back(eye);
            }
            for (unsigned bit = 1; bit <= 32; bit *= 2) {
                if (!contains(bit, eye.value())) continue;
                for (const EyePathClass& prefix : prefixes) EXPECT_TRUE(prefix.can_end_in(bit));
            }
            if (path.front() == Event::straight) {  // belongs to the look
                EyePathClass without;
                for (std::size_t j = 1; j < path.size(); ++j) without.add(path[j]);
                EXPECT_EQ(eye.value(), without.value());
                continue;
            }
            if (path.front() == Event::sharp) {
                EXPECT_EQ(eye.value(), PathClass::mirrored);
                continue;
            }
            for (const bool point_like : {false, true}) {
                LightPathClass light(point_like);
                for (std::size_t j = path.size() - 1; j > 0; --j) light.add(path[j]);
                const PathClass found = light.with(path.front());
                const bool sharply = point_like && (path.back() == Event::sharp || path.back() == Event::straight);
                if (sharply && eye.value() == PathClass::reflections) {
                    EXPECT_EQ(found, PathClass::sharply_lit);
                } else {
                    EXPECT_EQ(found, eye.value());
                }
            }
        }
    }
}

TEST(PathClass, ACausticIsAnInterfaceBehindABase) {
    EyePathClass path;
    EXPECT_EQ(path.value(), PathClass::seen);
    EXPECT_EQ(path.with(Event::base), PathClass::bases);
    EXPECT_EQ(path.with(Event::gloss), PathClass::reflections);
    path.add(Event::gloss);
    path.add(Event::base);
    EXPECT_EQ(path.value(), PathClass::reflections);
    EXPECT_EQ(path.with(Event::gloss), PathClass::caustics);
    EXPECT_TRUE(path.can_end_in(camera_tracer_owns));
    path.add(Event::sharp);
    EXPECT_FALSE(path.can_end_in(camera_tracer_owns));
}

}  // namespace
}  // namespace brewster
