#pragma once

#include "scene/planet.h"

namespace alpenglow {

/// What the planet's body is made of at a place; not metal.
struct BodyLook {
    glm::dvec3 albedo{0};
    double roughness = 1; ///< perceptual
};

/// As shaders/passes/planet.frag colours a procedural one, in the same single precision. `place`: world [m], on the
/// body; `footprint` [m]: how wide a pixel is there.
BodyLook look_of_body(Planet const& planet, glm::dvec3 const& place, double footprint);

} // namespace alpenglow
