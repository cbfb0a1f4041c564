#pragma once

#include <glm/glm.hpp>

namespace alpenglow {

/// What a surface reflects, as Surface of shaders/surface/brdf.glsl.
struct GroundSurface {
    glm::dvec3 diffuse{0};  ///< diffuse reflectance, 0..1
    glm::dvec3 specular{0}; ///< reflectance at normal incidence, 0..1
    double alpha = 1;       ///< GGX width: perceptual roughness squared
    double gloss = 0;       ///< weight of the specular part; 0: Lambert alone
};

/// What a ray meets: a place on the planet's body or on a scene's triangle, seen from the ray's side.
struct GroundPoint {
    double distance = 0; ///< [m] along the ray, to the surface itself
    /// World [m], moved off the surface along `facing`, so that rays from here don't meet it again.
    glm::dvec3 position{0};
    glm::dvec3 facing{0, 0, 1};  ///< unit, geometric normal on the ray's side
    glm::dvec3 shading{0, 0, 1}; ///< unit, from vertex normals and normal map; a bump may lean away from the ray
    GroundSurface surface{};
    glm::dvec3 emission{0}; ///< radiance, relative to the sun's irradiance
};

} // namespace alpenglow
