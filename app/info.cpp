#include "app/output.h"
#include "app/report.h"
#include "app/scene_summary.h"
#include "app/verbs.h"

namespace brewster {

void info(const InfoOptions& options) {
    Scene scene = read_scene(options.scene);
    apply_settings(scene, options.settings);
    print_result(options.json ? info_report(scene) : scene_summary(scene));
}

}  // namespace brewster
