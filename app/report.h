#pragma once
#include <array>
#include <string>
#include <vector>

#include "app/ground_truth.h"
#include "app/picture_names.h"
#include "app/pictures.h"
#include "base/fixed_point.h"
#include "engine/engine.h"
#include "image/compare.h"
#include "image/statistics.h"
#include "reference/reference.h"
#include "scene/scene.h"
#include "transport/ledger.h"

namespace brewster {

/// What a finished run of the engine says of itself.
struct SolveResult {
    std::string scene;
    EngineSettings settings;
    Progress progress;
    Ledger ledger;
    std::string digest;
    KernelChoice kernel;
};

/// What a finished reference says of itself.
struct ReferenceResult {
    std::string scene, camera, path;
    bool polarized = true;
    std::uint64_t seed = 1, samples = 0, photons = 0;  ///< samples for each pixel
    double seconds = 0;
    std::array<PictureMean, band_count> mean;  ///< of S0
};

SolveResult result_of(const Engine& engine);

/// 128-bit numbers in decimal digits: JSON numbers would lose them.
std::string decimal(Wide number);

/// One JSON object each, with a line break at its end. Units: seconds, bytes, lumens, metres; the ledger counts quanta,
/// per band, as decimal text.
std::string solve_report(const SolveResult& result);
std::string shot_report(const SolveResult& result, const PicturesResult& made,
                        const std::vector<PictureName>& pictures);
std::string info_report(const Scene& scene);
std::string reference_report(const ReferenceResult& result);
std::string compare_report(const PictureDifference& difference);
std::string develop_report(const std::vector<PictureName>& pictures, const PictureStatistics& statistics);

/// The cameras of pictures, see CameraMatrices; what cameras.json holds.
std::string camera_file(const Scene& scene, const std::vector<CameraRecord>& cameras);

}  // namespace brewster
