#pragma once

#include "scene/planet.h"
#include "support/gauss_legendre.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
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
        for (AirComponent const& component : air_.components) {
            if (auto const* const linear = std::get_if<LinearProfile>(&component.profile))
                for (LinearProfile::Node const& node : linear->nodes)
                    if (node.altitude > 0 && node.altitude < top) shells_.push_back(node.altitude);
        }
        shells_.push_back(top);
    }

    SingleScattering operator()(Sightline const& sight) const {
        auto const [start, end, ground] = segment(sight.origin, sight.direction);
        SingleScattering light;
        double const nu = glm::dot(sight.direction, sight.to_sun);
        std::vector<double> const at = view_cuts(sight, start, end);
        dvec3 depth(0);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            auto const source = [&](double t) {
                dvec3 const p = sight.origin + t * sight.direction;
                double const h = altitude(p);
                dvec3 const before = depth + piece(sight.origin, sight.direction, at[i], t);
                return scattered(h, nu) * glm::exp(-before - depth_to(p, sight.to_sun));
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
        dvec3 sum(0);
        for (AirComponent const& component : air_.components)
            sum += component.extinction() * density(component.profile, h);
        return sum;
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
    static double density(Profile const& profile, double h) {
        if (auto const* const exponential = std::get_if<ExponentialProfile>(&profile))
            return std::exp(-h / exponential->scale_height);
        auto const& nodes = std::get<LinearProfile>(profile).nodes;
        for (std::size_t i = 1; i < nodes.size(); ++i)
            if (h >= nodes[i - 1].altitude && h < nodes[i].altitude)
                return std::lerp(nodes[i - 1].density, nodes[i].density,
                                 (h - nodes[i - 1].altitude) / (nodes[i].altitude - nodes[i - 1].altitude));
        return 0;
    }

    static double lobe(PhaseLobe const& lobe, double nu) {
        double const g = lobe.g;
        return (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * nu, 1.5)) *
               (1 + lobe.alpha * nu * nu) / (1 + lobe.alpha * (1 + 2 * g * g) / 3);
    }

    /// Scattering times phase [1/(m sr)].
    dvec3 scattered(double h, double nu) const {
        dvec3 sum(0);
        for (AirComponent const& component : air_.components) {
            PhaseLobes const lobes = lobes_of(component.phase);
            double const phase = std::lerp(lobe(lobes.first, nu), lobe(lobes.second, nu), lobes.second_share);
            sum += component.scattering * (density(component.profile, h) * phase);
        }
        return sum;
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
