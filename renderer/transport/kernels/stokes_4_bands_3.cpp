#include "transport/block/trace_block.h"
#include "transport/scalar/trace_photon.h"

namespace brewster::transport {

template std::unique_ptr<PhotonTracer> scalar_tracer<4, 3, false>();
template std::unique_ptr<PhotonTracer> scalar_tracer<4, 3, true>();
template std::unique_ptr<PhotonTracer> block_tracer<4, 3, false>(std::size_t);
template std::unique_ptr<PhotonTracer> block_tracer<4, 3, true>(std::size_t);

}  // namespace brewster::transport
