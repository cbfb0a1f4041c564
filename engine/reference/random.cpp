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

constexpr Directions DIRECTIONS = make_directions();

std::uint32_t sobol(std::uint32_t index, std::uint32_t dimension) {
    std::uint32_t x = 0;
    for (std::uint32_t bit = 0; index != 0; ++bit, index >>= 1) {
        if (index & 1) x ^= DIRECTIONS[dimension][bit];
    }
    return x;
}

std::uint32_t reverse_bits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Owen scrambling: each bit is flipped by a hash of the bits above it (Laine and Karras 2011; constants of Burley).
std::uint32_t scramble(std::uint32_t x, std::uint32_t seed) {
    x = reverse_bits(x) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverse_bits(x);
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
    if (dimension == 0) set_index_ = scramble(index_, static_cast<std::uint32_t>(hash(key_, 2 * set)));
    // Bits below the Sobol number's are random too: a path's numbers then stay inside (0, 1).
    std::uint64_t const seed = hash(key_, (set * 4 + dimension) * 2 + 1);
    std::uint32_t const high = scramble(sobol(set_index_, dimension), static_cast<std::uint32_t>(seed));
    ++used_;
    return (static_cast<double>(high) + independent()) * 0x1p-32;
}

} // namespace alpenglow
