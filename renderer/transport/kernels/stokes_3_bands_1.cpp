#include "transport/scalar/trace_photon.h"

namespace brewster::transport {

template std::unique_ptr<PhotonTracer> scalar_tracer<3, 1, false>();
template std::unique_ptr<PhotonTracer> scalar_tracer<3, 1, true>();

}  // namespace brewster::transport
