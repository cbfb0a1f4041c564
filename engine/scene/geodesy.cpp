#include "scene/geodesy.h"

#include <cmath>

namespace alpenglow {

namespace {

glm::dvec3 up_at(double latitude, double longitude) {
    double const c = std::cos(latitude);
    return {c * std::cos(longitude), c * std::sin(longitude), std::sin(latitude)};
}

} // namespace

glm::dvec3 world_from_geodetic(Geodetic const& place, double radius) {
    return (radius + place.altitude) * up_at(place.latitude, place.longitude);
}

Geodetic geodetic_from_world(glm::dvec3 const& world, double radius) {
    double const from_axis = std::hypot(world.x, world.y);
    return {.latitude = std::atan2(world.z, from_axis),
            .longitude = std::atan2(world.y, world.x),
            .altitude = std::hypot(from_axis, world.z) - radius};
}

glm::dmat3 world_from_east_north_up(double latitude, double longitude) {
    double const sin_latitude = std::sin(latitude);
    double const sin_longitude = std::sin(longitude), cos_longitude = std::cos(longitude);
    glm::dvec3 const east{-sin_longitude, cos_longitude, 0};
    glm::dvec3 const north{-sin_latitude * cos_longitude, -sin_latitude * sin_longitude, std::cos(latitude)};
    return {east, north, up_at(latitude, longitude)};
}

glm::dvec3 world_from_elevation_azimuth(double elevation, double azimuth, double latitude, double longitude) {
    double const horizontal = std::cos(elevation);
    glm::dvec3 const east_north_up{horizontal * std::sin(azimuth), horizontal * std::cos(azimuth), std::sin(elevation)};
    return world_from_east_north_up(latitude, longitude) * east_north_up;
}

glm::dmat3 world_from_gltf_axes(double latitude, double longitude, double yaw) {
    glm::dmat3 const frame = world_from_east_north_up(latitude, longitude);
    double const c = std::cos(yaw), s = std::sin(yaw);
    glm::dvec3 const x = c * frame[0] - s * frame[1];
    glm::dvec3 const minus_z = s * frame[0] + c * frame[1];
    return {x, frame[2], -minus_z};
}

} // namespace alpenglow
