#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>

namespace brewster {

/// What a target was promised did not hold: ends the process, which the fuzzer takes for a find.
inline void promise(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
}

/// What a person reads when something fails.
inline void promise_one_sentence(const std::string& message) {
    promise(message.find('\n') == std::string::npos, "an error is one sentence");
}

struct Scene;

/// All that anything behind the reader takes for granted of a scene.
void check_scene(const Scene& scene);

}  // namespace brewster
