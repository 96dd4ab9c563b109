#include "app/memory.h"

#include <malloc.h>

#include <atomic>

#include "app/clock.h"

namespace brewster {

void keep_large_blocks_apart() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    mallopt(M_TRIM_THRESHOLD, 8 << 20);
#endif
}

void give_back_free_pages() {
#ifdef __GLIBC__
    constexpr double seconds_between = 10;
    static std::atomic<double> last = -seconds_between;
    const double now = seconds_now();
    double before = last;
    if (now - before < seconds_between || !last.compare_exchange_strong(before, now)) return;
    malloc_trim(0);
#endif
}

}  // namespace brewster
