#include <algorithm>

#include "app/divided_trace.h"
#include "app/output.h"
#include "app/pictures.h"
#include "app/report.h"
#include "app/trace.h"
#include "app/verbs.h"
#include "app/view_text.h"
#include "base/log.h"

namespace brewster {
namespace {

/// Each camera once, in the order of its pictures.
std::vector<const Camera*> cameras_of(const Scene& scene, const std::vector<PictureName>& pictures) {
    std::vector<const Camera*> cameras;
    for (const PictureName& picture : pictures) {
        const Camera* camera = &scene.camera(picture.camera);
        if (std::find(cameras.begin(), cameras.end(), camera) == cameras.end()) cameras.push_back(camera);
    }
    return cameras;
}

}  // namespace

void shot(const ShotOptions& options) {
    if (options.solve.json) log_only_warnings();
    const std::unique_ptr<Engine> engine = engine_for(options.solve);
    shot(*engine, options);
}

void shot(Engine& engine, const ShotOptions& wished) {
    ShotOptions options = wished;
    std::optional<Scene> with_views;
    if (!wished.views.empty()) add_views(with_views.emplace(engine.scene()), options);
    const Scene& scene = with_views ? *with_views : engine.scene();
    const std::vector<PictureName> pictures = plan_pictures(scene, options);
    std::optional<EyePictures> eye;
    if (options.gather) {
        const std::vector<const Camera*> cameras = cameras_of(scene, pictures);
        eye.emplace(scene, options);
        DrawRule rule{options.samples.value_or(default_samples), 0, {}};
        if (options.solve.resume.empty()) rule = trace_for_pictures(engine, *eye, cameras, options);
        eye->show(engine.snapshot(), rule, cameras.size());
    } else if (options.solve.resume.empty()) {
        trace(engine, options.solve.stop);
    }
    const PicturesResult made = write_pictures(scene, engine.snapshot(), options, pictures, eye ? &*eye : nullptr);

    if (options.solve.json) {
        print_result(shot_report(result_of(engine), made, pictures));
    } else {
        std::string list;
        for (const PictureName& picture : pictures) list += picture.path + "\n";
        print_result(list);
    }
}

}  // namespace brewster
