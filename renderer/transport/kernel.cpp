#include "transport/kernel.h"

#include "base/check.h"

namespace brewster {
namespace transport {

// Each kernel is compiled in a file of its own (kernels/).
template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> scalar_tracer();

}  // namespace transport

namespace {

template <int components, int bands>
std::unique_ptr<PhotonTracer> with_gloss(bool gloss) {
    return gloss ? transport::scalar_tracer<components, bands, true>()
                 : transport::scalar_tracer<components, bands, false>();
}

template <int components>
std::unique_ptr<PhotonTracer> with_bands(const KernelChoice& choice) {
    return choice.bands == 1 ? with_gloss<components, 1>(choice.gloss) : with_gloss<components, 3>(choice.gloss);
}

}  // namespace

std::unique_ptr<PhotonTracer> make_tracer(const KernelChoice& choice) {
    BREWSTER_CHECK(
        (choice.stokes == 1 || choice.stokes == 3 || choice.stokes == 4) && (choice.bands == 1 || choice.bands == 3),
        std::to_string(choice.stokes) + " " + std::to_string(choice.bands));
    if (choice.stokes == 1) return with_bands<1>(choice);
    return choice.stokes == 3 ? with_bands<3>(choice) : with_bands<4>(choice);
}

}  // namespace brewster
