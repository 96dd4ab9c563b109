#include "transport/kernel.h"

#include "base/check.h"
#include "transport/kernels/choose.h"

namespace brewster {
namespace transport {

// Each kernel is compiled in a file of its own (kernels/); blocks twice, where the compiler can.
template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> scalar_tracer();
template <int lanes>
std::unique_ptr<PhotonTracer> make_block_tracer(const KernelChoice& choice, std::size_t window);

}  // namespace transport

int widest_lanes() {
#if BREWSTER_HAS_WIDE_KERNELS
    static const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                             __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                             __builtin_cpu_supports("avx512vl");
    if (wide) return 16;
#endif
    return 8;
}

EntryFields entry_fields_of(const KernelChoice& choice, const Needs& needs) {
    const bool two_worlds = choice.stokes > 1;
    return {choice.bands, two_worlds && needs.polarized_lamps ? 2 : 1, two_worlds ? 2 : 1};
}

std::unique_ptr<PhotonTracer> make_tracer(const KernelChoice& choice, std::size_t window, int lanes) {
    BREWSTER_CHECK(
        (choice.stokes == 1 || choice.stokes == 3 || choice.stokes == 4) && (choice.bands == 1 || choice.bands == 3),
        std::to_string(choice.stokes) + " " + std::to_string(choice.bands));
    BREWSTER_CHECK(lanes == 8 || lanes == widest_lanes(), std::to_string(lanes));
    if (window == 0)
        return transport::with_kernel(choice, []<int components, int bands, bool gloss>() {
            return transport::scalar_tracer<components, bands, gloss>();
        });
#if BREWSTER_HAS_WIDE_KERNELS
    if (lanes == 16) return transport::make_block_tracer<16>(choice, window);
#endif
    return transport::make_block_tracer<8>(choice, window);
}

}  // namespace brewster
