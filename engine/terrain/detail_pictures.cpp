#include "terrain/detail_pictures.h"

#include "terrain/noise.h"
#include "core/parallel.h"
#include "terrain/tiles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace alpenglow {

namespace {

/// A square that repeats.
struct Grain {
    int size;
    std::vector<double> values;

    double& at(int x, int y) { return values[std::size_t((y + size) % size) * size + (x + size) % size]; }
    double at(int x, int y) const { return values[std::size_t((y + size) % size) * size + (x + size) % size]; }
};

/// Octaves from 1/6 of the period down to three texels. The broadest are weak: they would show that the picture
/// repeats.
Grain make_grain(std::uint32_t seed, int size, int threads) {
    Grain grain{size, std::vector<double>(std::size_t(size) * size)};
    parallel_for(size, threads, [&](int y) {
        for (int x = 0; x < size; ++x) {
            double sum = 0;
            std::uint32_t octave = 0;
            for (int waves = 6; 3 * waves <= size; waves *= 2, ++octave) {
                constexpr double broad_part = 0.35, decay = 0.72;
                double const amplitude = std::pow(decay, octave) * (octave == 0 ? broad_part : 1);
                double const scale = double(waves) / size;
                double const wave = gradient_noise(seed + octave, x * scale, y * scale, waves);
                sum += amplitude * (octave % 2 ? 0.5 - std::abs(wave) : wave); // blades and stones
            }
            grain.at(x, y) = sum;
        }
    });
    return grain;
}

/// To mean 0 and standard deviation 1.
void normalize(Grain& grain) {
    double sum = 0, squares = 0;
    for (double const v : grain.values) sum += v, squares += v * v;
    double const count = static_cast<double>(grain.values.size()), mean = sum / count;
    double const deviation = std::sqrt(squares / count - mean * mean);
    for (double& v : grain.values) v = (v - mean) / deviation;
}

/// What lies low between blades and stones lies in shade: at most 1 / DETAIL_MEAN - 1 = 0.25 above the mean, and
/// farther below it. `grain` of mean 0 and deviation 1; the mean of the result over a normal distribution is 0.
double shade_of(double grain) {
    constexpr double mean = 1.3272; // of the depth
    double const depth = std::clamp(1.3 - grain, 0.0, 3.0);
    return 0.25 * (1 - depth / mean);
}

double srgb_from_linear(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

std::uint8_t unorm8(double x) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0))); }

void put(std::uint8_t* texel, double r, double g, double b) {
    texel[0] = unorm8(r), texel[1] = unorm8(g), texel[2] = unorm8(b), texel[3] = 255;
}

} // namespace

DetailPictures make_detail_pictures(std::uint32_t seed, int size, int threads) {
    Grain height = make_grain(seed + 401, size, threads);
    normalize(height);
    // The same grain elsewhere and turned over: as good as another one.
    auto const tint = [&](int x, int y) { return height.at(y + size / 3, x + size / 5); };
    Extent const extent{static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(size)};
    DetailPictures pictures{ByteImage(extent), ByteImage(extent)};
    double const texel = DETAIL_PERIOD / size;
    constexpr double relief = 0.02; // [m] standard deviation of the grain's height
    parallel_for(size, threads, [&](int row) {
        for (int x = 0; x < size; ++x) {
            auto const column = static_cast<std::uint32_t>(x), line = static_cast<std::uint32_t>(row);
            double const shade = shade_of(0.8 * height.at(x, row) + 0.6 * tint(x, row));
            double const hue = 0.05 * std::clamp(tint(x + size / 2, row), -2.0, 2.0) * (0.25 - shade);
            double const level = DETAIL_MEAN * (1 + shade);
            put(pictures.color.at(column, line), srgb_from_linear(level * (1 + hue)), srgb_from_linear(level),
                srgb_from_linear(level * (1 - hue)));
            double const right = relief * (height.at(x + 1, row) - height.at(x - 1, row)) / (2 * texel);
            double const down = relief * (height.at(x, row + 1) - height.at(x, row - 1)) / (2 * texel);
            glm::dvec3 const n = 0.5 + 0.5 * glm::normalize(glm::dvec3(-right, down, 1));
            put(pictures.normal.at(column, line), n.x, n.y, n.z);
        }
    });
    return pictures;
}

} // namespace alpenglow
