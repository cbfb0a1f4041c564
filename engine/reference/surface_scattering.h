#pragma once

#include "reference/ground_point.h"
#include "scene/scene.h"

#include <optional>

namespace alpenglow {

/// The surface of a material; `roughness` is perceptual, `reflectance` a dielectric's at normal incidence.
GroundSurface make_ground_surface(glm::dvec3 const& albedo, double metalness, double roughness, double gloss = 1,
                                  double reflectance = Material::usual_reflectance);

/// Reflected radiance for a unit of irradiance across `to_light` [1/sr]: shaders/surface/brdf.glsl times the cosine
/// with the shading normal. 0 where the light stands below the horizon of the shading or of the geometric normal: what
/// comes through the surface is no light on it, so that bumps lose what they would scatter through it. Vectors are
/// unit.
glm::dvec3 reflect(GroundPoint const& point, glm::dvec3 const& to_viewer, glm::dvec3 const& to_light);

struct ReflectionSample {
    glm::dvec3 direction; ///< unit, to where the light comes from
    glm::dvec3 weight;    ///< reflect() / the direction's probability density
};

/// A direction for numbers in [0, 1): u1 chooses between the cosine around the shading normal and a mirror on a visible
/// facet, u2 and u3 the direction. Nothing where the light would come from below: such a sample counts as 0.
std::optional<ReflectionSample> sample_reflection(GroundPoint const& point, glm::dvec3 const& to_viewer, double u1,
                                                  double u2, double u3);

} // namespace alpenglow
