#pragma once

#include "scene/planet.h"
#include "support/gauss_legendre.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

/// Light scattered once, by quadrature in double precision. Written apart: nothing of `shaders/` or `engine/reference`.
namespace alpenglow::test {

using glm::dvec3;

/// A half line from inside or outside the air; the planet's centre is the origin.
struct Sightline {
    dvec3 origin;    ///< [m], not below the ground
    dvec3 direction; ///< unit
    dvec3 to_sun;    ///< unit; the sun is a point
};

/// Parts of the radiance [1/sr times the solar irradiance].
struct SingleScattering {
    dvec3 air{0};    ///< scattered once in the air
    dvec3 ground{0}; ///< direct sun on a Lambert ground, through the air
};

class SingleScatteringQuadrature {
public:
    /// `nodes` for each piece of a path: twice as many change nothing by more than 1e-9 (a test).
    explicit SingleScatteringQuadrature(Planet const& planet, int nodes = 10)
        : planet_(planet), air_(planet.air), rule_(nodes) {
        double const top = air_.top_altitude;
        for (double h = 0; h < top; h += std::max(1000.0, 0.3 * h)) shells_.push_back(h);
        for (double const kink : {-1.0, 0.0, 1.0}) {
            double const h = air_.ozone_centre + kink * air_.ozone_half_width;
            if (h > 0 && h < top) shells_.push_back(h);
        }
        shells_.push_back(top);
    }

    SingleScattering operator()(Sightline const& sight) const {
        auto const [start, end, ground] = segment(sight.origin, sight.direction);
        SingleScattering light;
        double const nu = glm::dot(sight.direction, sight.to_sun);
        dvec3 const rayleigh = air_.rayleigh.scattering * rayleigh_phase(nu);
        dvec3 const aerosol = air_.aerosol.scattering * cornette_shanks_phase(nu, air_.aerosol_g);
        std::vector<double> const at = view_cuts(sight, start, end);
        dvec3 depth(0);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            auto const source = [&](double t) {
                dvec3 const p = sight.origin + t * sight.direction;
                double const h = altitude(p);
                dvec3 const before = depth + piece(sight.origin, sight.direction, at[i], t);
                return (rayleigh * std::exp(-h / air_.rayleigh.scale_height) +
                        aerosol * std::exp(-h / air_.aerosol.scale_height)) *
                       glm::exp(-before - depth_to(p, sight.to_sun));
            };
            double const middle = 0.5 * (at[i] + at[i + 1]);
            if (lit(sight.origin + middle * sight.direction, sight.to_sun))
                light.air += rule_.integrate(at[i], at[i + 1], source);
            depth += piece(sight.origin, sight.direction, at[i], at[i + 1]);
        }
        if (ground) light.ground = ground_light(sight, end, depth);
        light.air *= planet_.solar_irradiance, light.ground *= planet_.solar_irradiance;
        return light;
    }

    /// Optical depth from a point to where the line leaves the air or meets the ground.
    dvec3 depth_to(dvec3 const& origin, dvec3 const& direction) const {
        auto const [start, end, ground] = segment(origin, direction);
        return depth(origin, direction, start, end);
    }

    /// Optical depth between two distances inside the air.
    dvec3 depth(dvec3 const& origin, dvec3 const& direction, double start, double end) const {
        std::vector<double> const at = cuts(origin, direction, start, end);
        dvec3 sum(0);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) sum += piece(origin, direction, at[i], at[i + 1]);
        return sum;
    }

    dvec3 extinction(double h) const {
        return air_.rayleigh.extinction * std::exp(-h / air_.rayleigh.scale_height) +
               air_.aerosol.extinction * std::exp(-h / air_.aerosol.scale_height) +
               air_.ozone_absorption * std::max(0.0, 1 - std::abs(h - air_.ozone_centre) / air_.ozone_half_width);
    }

    /// Part of a line that is in the air; end < start where there is none.
    struct Segment {
        double start, end;
        bool ground;
    };
    Segment segment(dvec3 const& origin, dvec3 const& direction) const {
        double const closest = -glm::dot(origin, direction);
        double const to_top = half_chord(origin, direction, air_.top_altitude);
        double const to_ground = half_chord(origin, direction, 0);
        double const start = std::max(0.0, closest - to_top);
        if (!(to_top > 0)) return {0, -1, false};
        bool const hit = closest > 0 && to_ground > 0;
        return {start, closest + (hit ? -to_ground : to_top), hit};
    }

private:
    static double rayleigh_phase(double nu) { return 3 / (16 * std::numbers::pi) * (1 + nu * nu); }
    static double cornette_shanks_phase(double nu, double g) {
        return 3 / (8 * std::numbers::pi) * (1 - g * g) * (1 + nu * nu) /
               ((2 + g * g) * std::pow(1 + g * g - 2 * g * nu, 1.5));
    }

    double altitude(dvec3 const& p) const { return glm::length(p) - planet_.radius; }

    /// From a line's closest point to where it crosses the sphere at altitude h; NaN where it misses that.
    double half_chord(dvec3 const& origin, dvec3 const& direction, double h) const {
        double const b = glm::dot(origin, direction), r = glm::length(origin), shell = planet_.radius + h;
        return std::sqrt(b * b - (r - shell) * (r + shell));
    }

    /// Whether a point is outside the planet's shadow.
    bool lit(dvec3 const& p, dvec3 const& to_sun) const {
        double const b = glm::dot(p, to_sun);
        return b > 0 || glm::dot(p, p) - b * b > planet_.radius * planet_.radius;
    }

    static void cut(std::vector<double>& at, double t, double start, double end) {
        if (t > start && t < end) at.push_back(t);
    }

    /// Distances that cut [start, end] at every shell, the ozone's kinks among them, and at the lowest point.
    std::vector<double> cuts(dvec3 const& origin, dvec3 const& direction, double start, double end) const {
        double const closest = -glm::dot(origin, direction);
        std::vector<double> at{start, end};
        cut(at, closest, start, end);
        for (double const h : shells_) {
            double const half = half_chord(origin, direction, h);
            cut(at, closest - half, start, end), cut(at, closest + half, start, end);
        }
        std::sort(at.begin(), at.end());
        return at;
    }

    /// The same, and where the rays to the sun graze a shell: the ground's is the edge of the planet's shadow.
    std::vector<double> view_cuts(Sightline const& sight, double start, double end) const {
        if (end <= start) return {};
        std::vector<double> at = cuts(sight.origin, sight.direction, start, end);
        auto const across = [&](dvec3 const& v) { return v - glm::dot(v, sight.to_sun) * sight.to_sun; };
        dvec3 const o = across(sight.origin), d = across(sight.direction);
        double const a = glm::dot(d, d), b = glm::dot(o, d);
        for (double const h : shells_) {
            double const r = planet_.radius + h,
                         root = std::sqrt(b * b - a * (glm::length(o) - r) * (glm::length(o) + r));
            cut(at, (-b - root) / a, start, end), cut(at, (-b + root) / a, start, end);
        }
        cut(at, -glm::dot(sight.origin, sight.to_sun) / glm::dot(sight.direction, sight.to_sun), start, end);
        std::sort(at.begin(), at.end());
        return at;
    }

    dvec3 piece(dvec3 const& origin, dvec3 const& direction, double a, double b) const {
        return rule_.integrate(a, b, [&](double t) { return extinction(altitude(origin + t * direction)); });
    }

    dvec3 ground_light(Sightline const& sight, double t, dvec3 const& depth_to_camera) const {
        dvec3 const up = glm::normalize(sight.origin + t * sight.direction);
        double const mu_s = glm::dot(up, sight.to_sun);
        if (mu_s <= 0) return dvec3(0);
        return planet_.ground_albedo / std::numbers::pi * mu_s *
               glm::exp(-depth_to_camera - depth_to(planet_.radius * up, sight.to_sun));
    }

    Planet planet_;
    Air air_;
    GaussLegendre rule_;
    std::vector<double> shells_; ///< altitudes [m]
};

} // namespace alpenglow::test
