#include "terrain/noise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alpenglow {

namespace {

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

/// Without a call into the library, which this is called too often for.
int floor_of(double x) {
    int const i = static_cast<int>(x);
    return i - (x < i);
}

int wrap(int i, int period) { return period > 0 ? ((i % period) + period) % period : i; }

/// Unit vectors: a table is an order of magnitude faster than a sine and a cosine for each corner.
std::array<std::array<double, 2>, 64> const DIRECTIONS = [] {
    std::array<std::array<double, 2>, 64> t{};
    for (std::size_t i = 0; i < t.size(); ++i) {
        double const angle = 2 * 3.14159265358979324 * static_cast<double>(i) / static_cast<double>(t.size());
        t[i] = {std::cos(angle), std::sin(angle)};
    }
    return t;
}();

double corner(std::uint32_t seed, int x, int y, double dx, double dy) {
    auto const& d = DIRECTIONS[lattice_hash(seed, x, y) >> 26];
    return d[0] * dx + d[1] * dy;
}

} // namespace

std::uint32_t lattice_hash(std::uint32_t seed, std::int32_t x, std::int32_t y) {
    std::uint32_t h = seed * 0x9E3779B9u + 0x7F4A7C15u;
    h = (h ^ static_cast<std::uint32_t>(x)) * 0x85EBCA6Bu;
    h ^= h >> 15;
    h = (h ^ static_cast<std::uint32_t>(y)) * 0xC2B2AE35u;
    h ^= h >> 13;
    h *= 0x27D4EB2Fu;
    return h ^ (h >> 16);
}

double lattice_unit(std::uint32_t seed, std::int32_t x, std::int32_t y) {
    return lattice_hash(seed, x, y) * (1.0 / 4294967296.0);
}

double gradient_noise(std::uint32_t seed, double x, double y, int period) {
    int const fx = floor_of(x), fy = floor_of(y);
    int const x0 = wrap(fx, period), y0 = wrap(fy, period);
    int const x1 = wrap(x0 + 1, period), y1 = wrap(y0 + 1, period);
    double const dx = x - fx, dy = y - fy, u = fade(dx), v = fade(dy);
    double const sw = corner(seed, x0, y0, dx, dy), se = corner(seed, x1, y0, dx - 1, dy);
    double const nw = corner(seed, x0, y1, dx, dy - 1), ne = corner(seed, x1, y1, dx - 1, dy - 1);
    double const low = sw + u * (se - sw), high = nw + u * (ne - nw); // std::lerp costs as much as the corners
    return 1.5 * (low + v * (high - low));
}

double fractal_noise(std::uint32_t seed, double x, double y, int octaves) {
    double sum = 0, amplitude = 0.5;
    for (int o = 0; o < octaves; ++o, amplitude *= 0.5) {
        sum += amplitude * gradient_noise(seed + static_cast<std::uint32_t>(o), x, y);
        // Turned by about 37 degrees, so that the lattices of the octaves don't line up.
        double const turned = 2 * (0.8 * x - 0.6 * y);
        y = 2 * (0.6 * x + 0.8 * y), x = turned;
    }
    return sum;
}

double ridged_noise(std::uint32_t seed, double x, double y, int octaves) {
    double sum = 0, amplitude = 0.5, weight = 1;
    for (int o = 0; o < octaves; ++o, amplitude *= 0.5) {
        double crest = 1 - std::abs(gradient_noise(seed + static_cast<std::uint32_t>(o), x, y));
        crest *= crest * weight;
        weight = std::clamp(2 * crest, 0.0, 1.0);
        sum += amplitude * crest;
        double const turned = 2 * (0.8 * x - 0.6 * y);
        y = 2 * (0.6 * x + 0.8 * y), x = turned;
    }
    return sum;
}

double smooth_step(double from, double to, double x) {
    double const t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace alpenglow
