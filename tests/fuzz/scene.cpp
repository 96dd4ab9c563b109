// Any bytes as a .gltf or .glb file: a sentence, or a scene that keeps all promises, may be asked by rays, and tells what
// it is.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "fuzz/json_mutator.h"
#include "fuzz/promises.h"
#include "scene/needs.h"
#include "scene/rays.h"
#include "scene/scene.h"

namespace brewster {
namespace {

void check_hits(const Scene& scene) {
    const Rays rays(scene);
    std::vector<Ray> asked(8);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        asked[i].origin = scene.radius() * glm::vec3(i & 1u ? 1 : -1, i & 2u ? 1 : -1, i & 4u ? 1 : -1);
        asked[i].direction = -asked[i].origin / (std::sqrt(3.0f) * scene.radius());
    }
    std::vector<Hit> hits(asked.size());
    rays.intersect(asked, hits);
    for (const Hit& hit : hits) {
        if (hit.escaped()) continue;
        promise(hit.triangle < scene.triangles.size(), "what is hit is there");
        promise(hit.chart == no_chart || hit.chart < scene.charts.size(), "its side is there");
        promise(std::isfinite(hit.distance + hit.position.x + hit.position.y + hit.position.z), "it is somewhere");
    }
}

}  // namespace
}  // namespace brewster

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace brewster;
    try {
        const Scene scene = read_scene_text({reinterpret_cast<const char*>(data), size}, "fuzz");
        check_scene(scene);
        check_hits(scene);
        promise(needs_of(scene).stokes >= 1, "light carries something");
    } catch (const Error& error) {
        const std::string message = error.what();
        promise(message.rfind("fuzz: ", 0) == 0, "an error names the file");
        promise_one_sentence(message);
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
    return brewster::mutate_json(data, size, most, seed, 8);
}
