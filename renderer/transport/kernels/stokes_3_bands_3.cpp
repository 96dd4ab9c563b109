#include "transport/trace_photon.h"

namespace brewster::transport {

template void trace_photon<3, 3, false>(const TransportContext&, std::uint64_t, WorkerSums&);
template void trace_photon<3, 3, true>(const TransportContext&, std::uint64_t, WorkerSums&);

}  // namespace brewster::transport
