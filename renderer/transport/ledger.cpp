#include "transport/ledger.h"

namespace brewster {

void Ledger::add(const Ledger& other) {
    for (std::size_t b = 0; b < emitted.size(); ++b) {
        emitted[b] += other.emitted[b];
        absorbed[b] += other.absorbed[b];
        escaped[b] += other.escaped[b];
        cut[b] += other.cut[b];
        roulette[b] += other.roulette[b];
        shading[b] += other.shading[b];
        capped[b] += other.capped[b];
    }
}

bool Ledger::balances() const {
    for (std::size_t b = 0; b < emitted.size(); ++b)
        if (emitted[b] != absorbed[b] + escaped[b] + cut[b] + roulette[b] + shading[b] + capped[b]) return false;
    return true;
}

}  // namespace brewster
