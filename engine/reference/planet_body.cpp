#include "reference/planet_body.h"

#include "surface/planet_look.glsl"

namespace alpenglow {

BodyLook look_of_body(Planet const& planet, glm::dvec3 const& place, double footprint) {
    glm::vec3 const unit(glm::normalize(place)), in_period(glm::mod(place, glm::dvec3(GROUND_PERIOD)));
    shader::GroundLookAt const look = shader::planet_look(
        unit, in_period, static_cast<float>(footprint / planet.radius), static_cast<float>(planet.radius));
    return {glm::dvec3(look.albedo), look.roughness};
}

} // namespace alpenglow
