#pragma once
#include <cstddef>
#include <new>

namespace brewster {

/// For std::vector: memory that begins on a cache line, so that four quanta at a multiple of four lie on one.
template <class Number>
struct LineAllocator {
    using value_type = Number;
    static constexpr std::align_val_t line{64};

    LineAllocator() = default;
    template <class Other>
    explicit LineAllocator(const LineAllocator<Other>&) {}

    Number* allocate(std::size_t count) { return static_cast<Number*>(::operator new(count * sizeof(Number), line)); }
    void deallocate(Number* from, std::size_t) { ::operator delete(from, line); }
    bool operator==(const LineAllocator&) const = default;
};

}  // namespace brewster
