#include "reference/sunlight.h"

#include <cmath>

namespace alpenglow {

Sunlight::Sunlight(LightSource const& source, OpticalDepth const& depth, Ground const& ground, double top_radius)
    : source_(source), depth_(&depth), ground_(&ground), top_radius_(top_radius),
      disc_height_(2 * std::pow(std::sin(0.5 * source.angular_radius), 2)) {}

glm::dvec3 Sunlight::through_air(glm::dvec3 const& place, glm::dvec3 const& direction) const {
    Ray const ray(place, direction);
    double const planet = depth_->planet_radius();
    if (ray.along < 0 && ray.closest_squared < planet * planet) return glm::dvec3(0);
    double const radius = ray.radius_at(0);
    if (radius >= top_radius_) {
        Span const air = span_inside(ray, top_radius_);
        if (air.empty() || ray.along >= 0) return source_.irradiance;
        return source_.irradiance * exp(-depth_->to_top(top_radius_, ray.mu_at(air.in)));
    }
    return source_.irradiance * exp(-depth_->to_top(radius, ray.along / radius));
}

glm::dvec3 Sunlight::unshadowed(glm::dvec3 const& place) const { return through_air(place, source_.to_sun); }

bool Sunlight::misses_planet(glm::dvec3 const& place) const {
    Ray const ray(place, source_.to_sun);
    double const planet = depth_->planet_radius();
    return ray.along >= 0 || ray.closest_squared >= planet * planet;
}

SunRay Sunlight::sample(glm::dvec3 const& place, double u1, double u2) const {
    SunRay ray{source_.to_sun};
    if (source_.irradiance == glm::dvec3(0)) return ray;
    if (disc_height_ > 0) ray.direction = around(source_.to_sun, 1 - disc_height_ * u1, u2);
    glm::dvec3 const irradiance = through_air(place, ray.direction);
    // What is too dark to matter needs no look at the scene.
    if (irradiance == glm::dvec3(0) || !ground_->sees_out(place, ray.direction)) return ray;
    ray.irradiance = irradiance;
    return ray;
}

} // namespace alpenglow
