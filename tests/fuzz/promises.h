#pragma once
#include <cstdio>
#include <cstdlib>

namespace brewster {

/// What a target was promised did not hold: ends the process, which the fuzzer takes for a find.
inline void promise(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
}

struct Scene;

/// All that anything behind the reader takes for granted of a scene.
void check_scene(const Scene& scene);

}  // namespace brewster
