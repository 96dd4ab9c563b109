#include "app/output.h"
#include "app/pictures.h"
#include "app/report.h"
#include "app/trace.h"
#include "app/verbs.h"
#include "base/log.h"

namespace brewster {

void shot(const ShotOptions& options) {
    if (options.solve.json) log_only_warnings();
    shot(load_scene(options.solve.scene, options.solve.settings), options);
}

void shot(const std::shared_ptr<const Scene>& scene, const ShotOptions& options) {
    const std::vector<PictureName> pictures = plan_pictures(*scene, options);
    Engine engine(scene, options.solve.engine);
    trace(engine, options.solve.stop);
    const float exposure = write_pictures(*scene, engine.snapshot(), options, pictures);

    if (options.solve.json) {
        print_result(shot_report(result_of(engine), exposure, pictures));
    } else {
        std::string list;
        for (const PictureName& picture : pictures) list += picture.path + "\n";
        print_result(list);
    }
}

}  // namespace brewster
