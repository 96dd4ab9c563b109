#include "base/zeroed_array.h"

#include <sys/mman.h>

#include <new>

namespace brewster {

void* resized_pages(void* pages, std::size_t from, std::size_t to) {
    if (to == 0) {
        if (pages) munmap(pages, from);
        return nullptr;
    }
    // mremap is Linux's own: it moves entries of the page table where a copy would touch every page twice.
    void* const found =
        pages ? mremap(pages, from, to, MREMAP_MAYMOVE)
              : mmap(nullptr, to, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (found == MAP_FAILED) throw std::bad_alloc();
    return found;
}

}  // namespace brewster
