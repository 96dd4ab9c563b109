#pragma once
#include <array>

#include "bins/record.h"

namespace brewster {

/// Spread of the replicas over sum w^2 of one cell: 1 for independent photons that deposit once.
struct Spread {
    std::array<double, replica_count> replicas{};
    double squares = 0;

    void add(const Spread& other) {
        for (std::size_t r = 0; r < replicas.size(); ++r) replicas[r] += other.replicas[r];
        squares += other.squares;
    }
    double variance() const {
        double mean = 0, sum = 0;
        for (const double r : replicas) mean += r / replica_count;
        for (const double r : replicas) sum += (r - mean) * (r - mean);
        return sum * replica_count / (replica_count - 1.0);
    }
};

}  // namespace brewster
