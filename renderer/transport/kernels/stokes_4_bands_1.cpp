#include "transport/trace_photon.h"

namespace brewster::transport {

template void trace_photon<4, 1, false>(const TransportContext&, std::uint64_t, WorkerSums&);
template void trace_photon<4, 1, true>(const TransportContext&, std::uint64_t, WorkerSums&);

}  // namespace brewster::transport
