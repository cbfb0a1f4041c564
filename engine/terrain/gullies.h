#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace alpenglow {

struct Gully {
    double height = 0;   ///< -1 in a gully, 1 on the rib beside it
    glm::dvec2 slope{0}; ///< about its derivative along the map's axes, for coordinates in wavelengths; continuous
};

/// Ribs and gullies, one a unit, that run along the unit vector `downhill`: waves from jittered lattice points, blended
/// by distance and brought to one amplitude (a phasor noise, Tricard and others 2019), with a crest sharper than a
/// cosine's.
Gully gully_noise(std::uint32_t seed, glm::dvec2 place, glm::dvec2 downhill);

} // namespace alpenglow
