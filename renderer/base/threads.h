#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace brewster {

/// As many threads as are wanted; 0: as the machine has.
inline unsigned thread_count(unsigned wanted = 0) {
    return wanted > 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

/// Calls work(index, thread) once for each index below `count`, in no order, on so many threads; the caller's is number
/// 0 of them. Returns when all is done. Threads that are started inherit the caller's priority.
template <class Work>
void on_threads(int count, unsigned threads, const Work& work) {
    std::atomic<int> next = 0;
    const auto take = [&](unsigned thread) {
        for (int index = next++; index < count; index = next++) work(index, thread);
    };
    std::vector<std::jthread> helpers;
    for (unsigned thread = 1; thread < threads; ++thread) helpers.emplace_back(take, thread);
    take(0);
}

/// Calls work(begin, end) for ranges of so many indices that together are those below `count`, on so many threads. Which
/// ranges there are does not depend on the threads, so sums over each may be floats.
template <class Work>
void over_ranges(std::size_t count, std::size_t length, unsigned threads, const Work& work) {
    const std::size_t ranges = (count + length - 1) / length;
    const auto enough = static_cast<unsigned>(std::min<std::size_t>(threads, ranges));
    on_threads(static_cast<int>(ranges), enough, [&](int range, unsigned) {
        const std::size_t begin = static_cast<std::size_t>(range) * length;
        work(begin, std::min(begin + length, count));
    });
}

}  // namespace brewster
