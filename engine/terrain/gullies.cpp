#include "terrain/gullies.h"

#include "terrain/noise.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace alpenglow {

Gully gully_noise(std::uint32_t seed, glm::dvec2 place, glm::dvec2 downhill) {
    constexpr double pi = 3.14159265358979324, reach = 1.25;
    glm::dvec2 const across(-downhill.y, downhill.x);
    int const x0 = static_cast<int>(std::floor(place.x)), y0 = static_cast<int>(std::floor(place.y));
    double real = 0, imaginary = 0, weights = 1e-9;
    for (int y = y0 - 1; y <= y0 + 1; ++y) {
        for (int x = x0 - 1; x <= x0 + 1; ++x) {
            std::uint32_t const h = lattice_hash(seed, x, y);
            glm::dvec2 const pivot(x + 0.15 + 0.7 / 65536 * (h & 0xFFFF), y + 0.15 + 0.7 / 65536 * (h >> 16));
            glm::dvec2 const from = place - pivot;
            double const near = 1 - glm::dot(from, from) / (reach * reach);
            if (near <= 0) continue;
            double const phase = 2 * pi * glm::dot(from, across), weight = near * near * near;
            real += weight * std::cos(phase);
            imaginary += weight * std::sin(phase);
            weights += weight;
        }
    }
    double const strength = std::hypot(real, imaginary) / weights, phase = std::atan2(imaginary, real);
    double const even = strength * strength * (3 - 2 * strength); // hides the creases where the waves cancel
    double const height = 0.5 * std::cos(phase) + 0.5 * (1 - 2 * std::abs(phase) / pi);
    // Of the whole as if it were a cosine: the true derivative jumps at the crest, and what follows it would too.
    return {even * height, even * 2 * pi * -std::sin(phase) * across};
}

} // namespace alpenglow
