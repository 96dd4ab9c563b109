#pragma once
#include "transport/kernel.h"

namespace brewster::transport {

/// Calls `make` with the template arguments of a kernel.
template <class Make>
std::unique_ptr<PhotonTracer> with_kernel(const KernelChoice& choice, const Make& make) {
    const auto with_bands = [&]<int components>() {
        if (choice.bands == 1)
            return choice.gloss ? make.template operator()<components, 1, true>()
                                : make.template operator()<components, 1, false>();
        return choice.gloss ? make.template operator()<components, 3, true>()
                            : make.template operator()<components, 3, false>();
    };
    if (choice.stokes == 1) return with_bands.template operator()<1>();
    return choice.stokes == 3 ? with_bands.template operator()<3>() : with_bands.template operator()<4>();
}

}  // namespace brewster::transport
