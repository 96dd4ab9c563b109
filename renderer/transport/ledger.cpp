#include "transport/ledger.h"

namespace brewster {

void Ledger::add(const Ledger& other) {
    for (std::size_t w = 0; w < world_count; ++w)
        for (std::size_t b = 0; b < band_count; ++b) {
            emitted[w][b] += other.emitted[w][b];
            absorbed[w][b] += other.absorbed[w][b];
            escaped[w][b] += other.escaped[w][b];
            cut[w][b] += other.cut[w][b];
            shading[w][b] += other.shading[w][b];
            capped[w][b] += other.capped[w][b];
            roulette[w][b] += other.roulette[w][b];
        }
}

bool Ledger::balances() const {
    for (std::size_t w = 0; w < world_count; ++w)
        for (std::size_t b = 0; b < band_count; ++b)
            if (emitted[w][b] !=
                absorbed[w][b] + escaped[w][b] + cut[w][b] + roulette[w][b] + shading[w][b] + capped[w][b])
                return false;
    return true;
}

}  // namespace brewster
