#include "base/lanes.h"
#include "transport/kernels/choose.h"

namespace brewster::transport {

template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> block_tracer(std::size_t window);

/// Photons in blocks, `lanes` at a time.
template <int lanes>
std::unique_ptr<PhotonTracer> make_block_tracer(const KernelChoice& choice, std::size_t window) {
    return with_kernel(choice, [window]<int components, int bands, bool gloss>() {
        return block_tracer<components, bands, gloss>(window);
    });
}
template std::unique_ptr<PhotonTracer> make_block_tracer<lane_count>(const KernelChoice&, std::size_t);

}  // namespace brewster::transport
