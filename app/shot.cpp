#include "app/output.h"
#include "app/pictures.h"
#include "app/report.h"
#include "app/trace.h"
#include "app/verbs.h"
#include "app/view_text.h"
#include "base/log.h"

namespace brewster {

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
    if (options.solve.resume.empty()) trace(engine, options.solve.stop);
    const PicturesResult made = write_pictures(scene, engine.snapshot(), options, pictures);

    if (options.solve.json) {
        print_result(shot_report(result_of(engine), made, pictures));
    } else {
        std::string list;
        for (const PictureName& picture : pictures) list += picture.path + "\n";
        print_result(list);
    }
}

}  // namespace brewster
