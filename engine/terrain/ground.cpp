#include "terrain/ground.h"

#include "terrain/noise.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace alpenglow {

namespace {

// Broadband albedos of Oke 1987 (table 1.1) within their ranges; hues tuned by eye.
constexpr glm::dvec3 SAND{0.30, 0.25, 0.18}, FOREST{0.024, 0.042, 0.018}, MEADOW{0.070, 0.105, 0.036},
    HAY{0.115, 0.125, 0.050}, HEATH{0.105, 0.098, 0.052}, SCREE{0.26, 0.25, 0.232}, PALE_ROCK{0.240, 0.226, 0.207},
    DARK_ROCK{0.128, 0.122, 0.114}, SNOW{0.78, 0.80, 0.83};

/// Noises that all kinds of ground share, about -1 to 1.
struct Chance {
    double broad;   ///< over kilometres
    double patches; ///< from 200 m down
    double ragged;  ///< from 70 m down
    double fine;    ///< from 17 m down
};

Chance chance_at(std::uint32_t seed, GroundPlace const& p) {
    double const x = p.east / 1000, y = p.north / 1000;
    return {fractal_noise(seed + 301, 0.6 * x, 0.6 * y, 4), fractal_noise(seed + 311, 5 * x, 5 * y, 3),
            fractal_noise(seed + 321, 14 * x, 14 * y, 3), fractal_noise(seed + 331, 60 * x, 60 * y, 3)};
}

/// Parcels of mown and tall grass on the valley floors, each of one brightness, 0 to 1.
double parcel(std::uint32_t seed, double east, double north) {
    double const x = east / 170, y = north / 110;
    int const x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    double nearest = 1e9, shade = 0;
    for (int j = y0 - 1; j <= y0 + 1; ++j) {
        for (int i = x0 - 1; i <= x0 + 1; ++i) {
            double const px = i + lattice_unit(seed, i, j), py = j + lattice_unit(seed + 1, i, j);
            double const distance = (x - px) * (x - px) + (y - py) * (y - py);
            if (distance < nearest) nearest = distance, shade = lattice_unit(seed + 2, i, j);
        }
    }
    return shade;
}

glm::dvec3 grass(std::uint32_t seed, GroundPlace const& p, Chance const& c) {
    double const farmed = smooth_step(0.14, 0.06, p.slope) * smooth_step(1400, 1100, p.altitude);
    double const hay = std::lerp(0.3 + 0.5 * c.patches, farmed > 0 ? parcel(seed + 341, p.east, p.north) : 0.0, farmed);
    glm::dvec3 const meadow = glm::mix(MEADOW, HAY, std::clamp(hay, 0.0, 1.0)) * (1 + 0.25 * c.ragged + 0.3 * c.fine);
    return glm::mix(meadow, HEATH * (1 + 0.4 * c.ragged + 0.3 * c.fine),
                    smooth_step(1700, 2350, p.altitude + 500 * c.broad + 300 * c.ragged));
}

/// Beds of harder and softer stone, dipping to the north-west and bent a little.
glm::dvec3 rock(std::uint32_t seed, GroundPlace const& p, Chance const& c) {
    double const level = p.altitude + 0.22 * p.east - 0.16 * p.north + 90 * c.broad + 14 * c.patches;
    double const beds = fractal_noise(seed + 351, level / 150, 0.5, 4);
    double const pale = smooth_step(-0.22, 0.22, beds + 0.6 * c.broad + 0.25 * c.ragged);
    return glm::mix(DARK_ROCK, PALE_ROCK, pale) * (1 + 0.55 * c.fine + 0.25 * c.ragged + 0.1 * p.gully);
}

/// Broken at its edges, thin at its upper limit, cut by the gullies that avalanches keep open.
double forest(GroundPlace const& p, Chance const& c) {
    double const edge = c.patches + 0.8 * c.ragged + 0.35 * c.fine;
    double const line = smooth_step(1950, 1550, p.altitude + 350 * c.broad + 250 * edge);
    double const wanted = 0.55 * smooth_step(0.08, 0.3, p.slope) + 0.9 * c.broad + 0.12 * p.northward +
                          0.25 * std::min(p.gully + 0.2, 0.0) + 0.6 * edge + 0.8 * line - 1.05;
    return smooth_step(-0.04, 0.06, wanted) * smooth_step(1.25, 0.95, p.slope);
}

} // namespace

glm::dvec3 ground_albedo(std::uint32_t seed, GroundPlace const& p) {
    if (p.altitude < -2) return SAND;
    Chance const c = chance_at(seed, p);
    glm::dvec3 color = grass(seed, p, c);
    color = glm::mix(color, FOREST * (1 + 0.9 * c.fine + 0.3 * c.ragged), forest(p, c));

    // Stones lie in gullies and under faces, at the slope that they come to rest on.
    double const stony = 0.5 * smooth_step(1700, 2500, p.altitude + 350 * c.broad) - 0.35 * p.gully +
                         1.1 * smooth_step(0.35, 0.7, p.slope) + 0.5 * c.patches + 0.5 * c.ragged - 1.0;
    color = glm::mix(color, SCREE * (1 + 0.25 * c.fine + 0.15 * c.ragged),
                     smooth_step(-0.08, 0.12, stony) * smooth_step(900, 1500, p.altitude + 300 * c.patches));
    double const steep = p.slope + 0.22 * c.patches + 0.22 * c.ragged + 0.0002 * (p.altitude - 2000) + 0.08 * p.gully;
    if (double const bare = smooth_step(0.78, 0.9, steep); bare > 0) color = glm::mix(color, rock(seed, p, c), bare);
    color = glm::mix(color, SAND * (1 + 0.2 * c.fine), smooth_step(14, 7, p.altitude + 4 * c.patches));

    // Snow lies lower on shaded faces and in gullies, slides off steep ones, and wind takes it in patches.
    double const line = 2600 - 330 * p.northward + 300 * c.broad + 220 * c.patches + 160 * c.ragged + 170 * p.gully;
    double const held = 1.12 - 0.22 * p.gully + 0.00012 * (p.altitude - 2600) -
                        (p.slope + 0.25 * c.patches + 0.3 * c.ragged + 0.1 * c.fine);
    double const snow = smooth_step(line - 40, line + 90, p.altitude) * smooth_step(-0.05, 0.08, held);
    return glm::mix(color, SNOW * (1 + 0.04 * c.fine), snow);
}

} // namespace alpenglow
