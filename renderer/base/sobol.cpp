#include "base/sobol.h"

#include <array>

#include "base/owen.h"
#include "base/philox.h"

namespace brewster {
namespace {

// Primitive polynomials and initial direction numbers m_i of new-joe-kuo-6, dimensions 2 to 8: degree s, coefficient
// bits a, m_1..m_s. Dimension 1 is the van der Corput sequence.
struct Polynomial {
    unsigned degree;
    unsigned coefficients;
    std::array<std::uint32_t, 5> initial;
};
constexpr std::array<Polynomial, sobol_dimensions - 1> polynomials = {{{1, 0, {1}},
                                                                       {2, 1, {1, 3}},
                                                                       {3, 1, {1, 3, 1}},
                                                                       {3, 2, {1, 1, 1}},
                                                                       {4, 1, {1, 1, 3, 3}},
                                                                       {4, 4, {1, 3, 5, 13}},
                                                                       {5, 2, {1, 1, 5, 5, 17}}}};

using Matrix = std::array<std::uint32_t, 32>;  // column i: the direction number of index bit i

constexpr std::array<Matrix, sobol_dimensions> direction_numbers() {
    std::array<Matrix, sobol_dimensions> matrices{};
    for (unsigned bit = 0; bit < 32; ++bit) matrices[0][bit] = 1u << (31 - bit);
    for (unsigned d = 1; d < sobol_dimensions; ++d) {
        const Polynomial& p = polynomials[d - 1];
        Matrix& v = matrices[d];
        for (unsigned i = 0; i < 32; ++i) {
            if (i < p.degree) {
                v[i] = p.initial[i] << (31 - i);
                continue;
            }
            v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
            for (unsigned k = 1; k < p.degree; ++k) {
                if ((p.coefficients >> (p.degree - 1 - k)) & 1u) v[i] ^= v[i - k];
            }
        }
    }
    return matrices;
}

// One table a byte of the index: four look-ups and three exclusive ors a point.
using ByteTables = std::array<std::array<std::array<std::uint32_t, 256>, 4>, sobol_dimensions>;

ByteTables byte_tables() {
    constexpr auto matrices = direction_numbers();
    ByteTables tables{};
    for (unsigned d = 0; d < sobol_dimensions; ++d)
        for (unsigned byte = 0; byte < 4; ++byte)
            for (unsigned value = 0; value < 256; ++value)
                for (unsigned bit = 0; bit < 8; ++bit)
                    if ((value >> bit) & 1u) tables[d][byte][value] ^= matrices[d][8 * byte + bit];
    return tables;
}

const ByteTables& tables() {
    static const ByteTables all = byte_tables();
    return all;
}

}  // namespace

std::uint32_t sobol_owen(std::uint32_t index, unsigned dimension, std::uint32_t scramble) {
    const auto& table = tables()[dimension];
    const std::uint32_t point =
        table[0][index & 255u] ^ table[1][(index >> 8) & 255u] ^ table[2][(index >> 16) & 255u] ^ table[3][index >> 24];
    return reverse_bits(permute_upwards(reverse_bits(point), scramble));
}

WordLanes sobol_owen(WordLanes index, unsigned dimension, WordLanes scramble) {
    const auto& table = tables()[dimension];
    const WordLanes byte(255u);
    const WordLanes point = gather<1>(table[0].data(), index & byte) ^ gather<1>(table[1].data(), (index >> 8) & byte) ^
                            gather<1>(table[2].data(), (index >> 16) & byte) ^ gather<1>(table[3].data(), index >> 24);
    return reverse_bits(permute_upwards(reverse_bits(point), scramble));
}

std::uint32_t scramble_of(std::uint64_t seed, std::uint32_t replica, std::uint32_t dimension) {
    return philox(seed, 0x5bd1e995ull + replica, dimension, 0x736f626fu)[0];
}

}  // namespace brewster
