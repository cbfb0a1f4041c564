#include "terrain/ground.h"

#include "terrain/noise.h"

#include <glm/common.hpp>

namespace alpenglow {

namespace {

// Broadband albedos of Oke 1987 (table 1.1) within their ranges; hues tuned by eye.
constexpr glm::dvec3 SAND{0.30, 0.25, 0.18}, FOREST{0.026, 0.044, 0.018}, MEADOW{0.070, 0.110, 0.034},
    HEATH{0.115, 0.105, 0.050}, SCREE{0.21, 0.20, 0.185}, PALE_ROCK{0.22, 0.205, 0.185}, DARK_ROCK{0.135, 0.125, 0.115},
    SNOW{0.78, 0.80, 0.83};

} // namespace

glm::dvec3 ground_albedo(std::uint32_t seed, GroundPlace const& p) {
    double const x = p.east / 1000, y = p.north / 1000;
    double const broad = fractal_noise(seed + 301, 0.6 * x, 0.6 * y, 4),
                 patches = fractal_noise(seed + 311, 5 * x, 5 * y, 5);
    double const fine = fractal_noise(seed + 331, 60 * x, 60 * y, 3);

    glm::dvec3 const meadow = MEADOW * (1 + 0.35 * patches + 0.25 * fine);
    glm::dvec3 color = glm::mix(meadow, HEATH * (1 + 0.3 * fine), smooth_step(1500, 2300, p.altitude + 500 * broad));
    double const trees = smooth_step(1850, 1600, p.altitude + 350 * broad) *
                         smooth_step(0.04, 0.16, p.slope + 0.12 * patches) *
                         smooth_step(-0.25, 0.02, patches + 0.35 * broad + 0.1 * p.northward);
    color = glm::mix(color, FOREST * (1 + 0.4 * fine), trees);
    double const scree =
        smooth_step(1500, 2500, p.altitude + 400 * patches) * smooth_step(0.3, 0.6, p.slope + 0.3 * patches);
    color = glm::mix(color, SCREE * (1 + 0.2 * fine), scree);
    glm::dvec3 const rock =
        glm::mix(PALE_ROCK, DARK_ROCK, smooth_step(-0.3, 0.3, broad + 0.5 * patches)) * (1 + 0.25 * fine);
    color = glm::mix(color, rock, smooth_step(0.72, 0.98, p.slope + 0.2 * patches + 0.00006 * (p.altitude - 1500)));
    color = glm::mix(color, SAND * (1 + 0.2 * fine), smooth_step(14, 7, p.altitude + 4 * patches));

    // Snow lies lower on shaded faces and slides off steep ones; wind takes it in patches.
    double const line = 2450 - 350 * p.northward + 350 * broad + 300 * patches;
    double const snow = smooth_step(line - 150, line + 250, p.altitude) *
                        smooth_step(1.25, 0.85, p.slope + 0.25 * patches + 0.1 * fine);
    return glm::mix(color, SNOW * (1 + 0.03 * fine), snow);
}

} // namespace alpenglow
