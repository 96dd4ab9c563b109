#include "transport/block/trace_block.h"
#if !BREWSTER_WIDE
#include "transport/scalar/trace_photon.h"
#endif

namespace brewster::transport {

template std::unique_ptr<PhotonTracer> block_tracer<3, 3, false>(std::size_t);
template std::unique_ptr<PhotonTracer> block_tracer<3, 3, true>(std::size_t);
#if !BREWSTER_WIDE
template std::unique_ptr<PhotonTracer> scalar_tracer<3, 3, false>();
template std::unique_ptr<PhotonTracer> scalar_tracer<3, 3, true>();
#endif

}  // namespace brewster::transport
