#pragma once
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace brewster {

/// Sets of the numbers 0 .. size - 1 that only ever join (Tarjan 1975); a set is named by its smallest member.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t find(std::uint32_t member) {
        while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
        return member;
    }

    /// The name of the joined set.
    std::uint32_t join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (b < a) std::swap(a, b);
        return parent_[b] = a;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace brewster
