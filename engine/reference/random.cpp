#include "reference/random.h"

#include <array>

namespace alpenglow {

namespace {

using Directions = std::array<std::array<std::uint32_t, 32>, 4>;

/// Direction numbers of the first four Sobol dimensions, from primitive polynomials and initial values (Joe and Kuo
/// 2008, new-joe-kuo-6.21201: degree s, coefficients a, and m).
constexpr Directions make_directions() {
    struct Polynomial {
        std::uint32_t degree, coefficients;
        std::array<std::uint32_t, 3> initial;
    };
    constexpr std::array<Polynomial, 3> polynomials{{{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}}};
    Directions v{};
    for (std::uint32_t i = 0; i < 32; ++i) v[0][i] = 1u << (31 - i);
    for (std::uint32_t d = 1; d < 4; ++d) {
        Polynomial const p = polynomials[d - 1];
        for (std::uint32_t i = 0; i < 32; ++i) {
            if (i < p.degree) {
                v[d][i] = p.initial[i] << (31 - i);
                continue;
            }
            std::uint32_t value = v[d][i - p.degree] ^ (v[d][i - p.degree] >> p.degree);
            for (std::uint32_t k = 1; k < p.degree; ++k) {
                if ((p.coefficients >> (p.degree - 1 - k)) & 1) value ^= v[d][i - k];
            }
            v[d][i] = value;
        }
    }
    return v;
}

/// For each byte of an index, its share of the Sobol number; bits in reversed order, as the scrambling wants them.
using Shares = std::array<std::array<std::array<std::uint32_t, 4>, 256>, 4>;

constexpr Shares make_shares() {
    Directions const directions = make_directions();
    Shares shares{};
    for (std::uint32_t byte = 0; byte < 4; ++byte) {
        for (std::uint32_t i = 0; i < 256; ++i) {
            for (std::uint32_t d = 0; d < 4; ++d) {
                std::uint32_t x = 0;
                for (std::uint32_t bit = 0; bit < 8; ++bit) x ^= (i >> bit) & 1 ? directions[d][byte * 8 + bit] : 0;
                for (std::uint32_t bit = 0; bit < 32; ++bit) shares[byte][i][d] |= ((x >> bit) & 1) << (31 - bit);
            }
        }
    }
    return shares;
}

Shares const SHARES = make_shares();

std::uint32_t reversed_sobol(std::uint32_t index, std::uint32_t d) {
    return SHARES[0][index & 255][d] ^ SHARES[1][(index >> 8) & 255][d] ^ SHARES[2][(index >> 16) & 255][d] ^
           SHARES[3][index >> 24][d];
}

std::uint32_t reverse_bits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Owen scrambling of a number whose bits are reversed: each bit is flipped by a hash of those that were above it
/// (Laine and Karras 2011; constants of Burley).
std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

} // namespace

std::uint64_t hash(std::uint64_t a, std::uint64_t b) {
    std::uint64_t x = a + 0x9e3779b97f4a7c15u * (b + 1);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

double PathNumbers::independent() {
    state_ = hash(state_, 0);
    return (static_cast<double>(state_ >> 11) + 0.5) * 0x1p-53;
}

double PathNumbers::next() {
    if (used_ >= SOBOL_NUMBERS) return independent();
    auto const set = static_cast<std::uint64_t>(used_ / 4);
    auto const dimension = static_cast<std::uint32_t>(used_ % 4);
    if (dimension == 0) {
        seeds_ = hash(key_, set);
        // The same scrambling on the index itself shuffles it, within each power of two.
        place_ = reverse_bits(scramble_reversed(reverse_bits(index_), static_cast<std::uint32_t>(seeds_ >> 32)));
    }
    std::uint32_t const seed = static_cast<std::uint32_t>(seeds_) + 0x9e3779b9u * dimension;
    ++used_;
    return (reverse_bits(scramble_reversed(reversed_sobol(place_, dimension), seed * 0x85ebca6bu)) + 0.5) * 0x1p-32;
}

} // namespace alpenglow
