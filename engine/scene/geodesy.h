#pragma once

#include <glm/glm.hpp>

namespace alpenglow {

/// World frame: planet-centred, right-handed; +Z is the north pole, +X is latitude 0, longitude 0. Metres, doubles.
struct Geodetic {
    double latitude = 0;  ///< [rad], north positive
    double longitude = 0; ///< [rad], east positive
    double altitude = 0;  ///< [m] above the planet's reference radius
};

glm::dvec3 world_from_geodetic(Geodetic const& place, double radius);
Geodetic geodetic_from_world(glm::dvec3 const& world, double radius);

/// Columns: east, north, up. Defined everywhere, poles included (east there is that of the given longitude).
glm::dmat3 world_from_east_north_up(double latitude, double longitude);

/// Unit vector from elevation above the horizon and azimuth (clockwise from north), both [rad], in the frame at a
/// place.
glm::dvec3 world_from_elevation_azimuth(double elevation, double azimuth, double latitude, double longitude);

/// glTF axes in a local tangent frame: +Y up, +X east, -Z north, turned by `yaw` [rad] clockwise seen from above.
/// Columns of the rotation; the translation is world_from_geodetic.
glm::dmat3 world_from_gltf_axes(double latitude, double longitude, double yaw);

} // namespace alpenglow
