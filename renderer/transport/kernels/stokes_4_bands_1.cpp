#include "transport/block/trace_block.h"
#if !BREWSTER_WIDE
#include "transport/scalar/trace_photon.h"
#endif

namespace brewster::transport {

template std::unique_ptr<PhotonTracer> block_tracer<4, 1, false>(std::size_t);
template std::unique_ptr<PhotonTracer> block_tracer<4, 1, true>(std::size_t);
#if !BREWSTER_WIDE
template std::unique_ptr<PhotonTracer> scalar_tracer<4, 1, false>();
template std::unique_ptr<PhotonTracer> scalar_tracer<4, 1, true>();
#endif

}  // namespace brewster::transport
