#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace brewster {

/// Runs trace(first, end) for ranges of `block` indices out of [first, first + count) on so many threads, and hands what
/// each returns to take(result) one at a time and in the order of the indices: sums of floating point numbers then do
/// not depend on the threads.
template <class Trace, class Take>
void in_ordered_blocks(std::uint64_t first, std::uint64_t count, std::uint64_t block, unsigned threads,
                       const Trace& trace, const Take& take) {
    const std::uint64_t blocks = (count + block - 1) / block;
    std::atomic<std::uint64_t> next = 0;
    std::mutex mutex;
    std::map<std::uint64_t, decltype(trace(first, first))> finished;  // blocks that wait for an earlier one
    std::uint64_t taken = 0;
    const auto work = [&] {
        for (std::uint64_t b = next++; b < blocks; b = next++) {
            auto result = trace(first + b * block, first + std::min(count, (b + 1) * block));
            const std::lock_guard lock(mutex);
            finished.emplace(b, std::move(result));
            for (auto at = finished.find(taken); at != finished.end(); at = finished.find(++taken)) {
                take(at->second);
                finished.erase(at);
            }
        }
    };
    std::vector<std::jthread> helpers;
    for (unsigned t = 1; t < threads; ++t) helpers.emplace_back(work);
    work();
}

}  // namespace brewster
