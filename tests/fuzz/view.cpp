// Any text as the value of --view: a sentence, or a view that its own text says again and a camera that looks somewhere.
#include <cmath>
#include <string>

#include "app/view_text.h"
#include "base/error.h"
#include "fuzz/promises.h"
#include "scene/mutations.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace brewster;
    static const Scene scene = read_scene_text(whole_file().text(), "whole");
    const auto finite = [](const glm::vec3& v) { return std::isfinite(v.x + v.y + v.z); };
    try {
        const View view = parse_view({reinterpret_cast<const char*>(data), size});
        const std::string text = view_text(view);
        promise(parse_view(text) == view, "a view's text is that view");
        const Camera camera = camera_of(scene, view);
        promise(finite(camera.position) && finite(camera.forward) && finite(camera.up), "a camera is somewhere");
        promise(std::abs(glm::length(camera.forward) - 1) < 1e-4f, "a camera looks somewhere");
    } catch (const Error& error) {
        promise_one_sentence(error.what());
    }
    return 0;
}
