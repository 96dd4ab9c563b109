#include "transport/kernel.h"

#include "base/check.h"

namespace brewster {
namespace transport {

// Each kernel is compiled in a file of its own (kernels/).
template <int components, int bands, bool gloss>
void trace_photon(const TransportContext& context, std::uint64_t photon, WorkerSums& sums);

}  // namespace transport

namespace {

template <int components, int bands>
TracePhoton with_gloss(bool gloss) {
    return gloss ? transport::trace_photon<components, bands, true> : transport::trace_photon<components, bands, false>;
}

template <int components>
TracePhoton with_bands(const KernelChoice& choice) {
    return choice.bands == 1 ? with_gloss<components, 1>(choice.gloss) : with_gloss<components, 3>(choice.gloss);
}

}  // namespace

TracePhoton kernel_for(const KernelChoice& choice) {
    BREWSTER_CHECK(
        (choice.stokes == 1 || choice.stokes == 3 || choice.stokes == 4) && (choice.bands == 1 || choice.bands == 3),
        std::to_string(choice.stokes) + " " + std::to_string(choice.bands));
    if (choice.stokes == 1) return with_bands<1>(choice);
    return choice.stokes == 3 ? with_bands<3>(choice) : with_bands<4>(choice);
}

}  // namespace brewster
