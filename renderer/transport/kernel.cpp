#include "transport/kernel.h"

#include "base/check.h"

namespace brewster {
namespace transport {

// Each kernel is compiled in a file of its own (kernels/).
template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> scalar_tracer();
template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> block_tracer(std::size_t window);

}  // namespace transport

namespace {

template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> with_window(std::size_t window) {
    if (window == 0) return transport::scalar_tracer<components, bands, gloss>();
    return transport::block_tracer<components, bands, gloss>(window);
}

template <int components, int bands>
std::unique_ptr<PhotonTracer> with_gloss(bool gloss, std::size_t window) {
    return gloss ? with_window<components, bands, true>(window) : with_window<components, bands, false>(window);
}

template <int components>
std::unique_ptr<PhotonTracer> with_bands(const KernelChoice& choice, std::size_t window) {
    return choice.bands == 1 ? with_gloss<components, 1>(choice.gloss, window)
                             : with_gloss<components, 3>(choice.gloss, window);
}

}  // namespace

std::unique_ptr<PhotonTracer> make_tracer(const KernelChoice& choice, std::size_t window) {
    BREWSTER_CHECK(
        (choice.stokes == 1 || choice.stokes == 3 || choice.stokes == 4) && (choice.bands == 1 || choice.bands == 3),
        std::to_string(choice.stokes) + " " + std::to_string(choice.bands));
    if (choice.stokes == 1) return with_bands<1>(choice, window);
    return choice.stokes == 3 ? with_bands<3>(choice, window) : with_bands<4>(choice, window);
}

}  // namespace brewster
