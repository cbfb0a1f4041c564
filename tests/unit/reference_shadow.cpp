#include "reference/terrain_mesh.h"
#include "support/scenes.h"
#include "support/single_scattering.h"
#include "support/traced_world.h"

#include <gtest/gtest.h>

/// A wall across the sun's azimuth: where its shadow ends, on the ground and in the air.
using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr double HEIGHT = 300; ///< [m] of the wall over the reference sphere

Planet planet_of(bool air) {
    Planet planet = make_earth();
    planet.has_air = air;
    planet.look = GroundLook::uniform;
    planet.ground_albedo = glm::dvec3(0.5);
    return planet;
}

/// The wall stands `away` [m] north of the scene's anchor, across north; the ground bends below the anchor's level.
struct Wall {
    Planet planet;
    double away;
    Placement placement{{.latitude = 0.3, .longitude = -1.1, .altitude = 0}};
    Scene scene = scene_of({matte(glm::vec3(0.5f))});
    dvec3 anchor, east, north, up;

    Wall(Planet const& p, double distance) : planet(p), away(distance) {
        double const over_anchor = std::sqrt(std::pow(planet.radius + HEIGHT, 2) - away * away) - planet.radius;
        // A chip of the ground as far on the other side: the scene's middle stays at the anchor.
        add_quad(scene, {0, -2 * HEIGHT, away}, {1, 0, 0}, {0, 1, 0});
        // Half axes: 20 km to each side, and deep enough to reach into the ground.
        add_quad(scene, {0, over_anchor - 2 * HEIGHT, -away}, {20000, 0, 0}, {0, 2 * HEIGHT, 0});
        anchor = world_from_geodetic(placement.anchor, planet.radius);
        glm::dmat3 const axes = world_from_east_north_up(placement.anchor.latitude, placement.anchor.longitude);
        east = axes[0], north = axes[1], up = axes[2];
    }

    dvec3 top_edge() const {
        double const r = planet.radius + HEIGHT;
        return std::sqrt(r * r - away * away) * up + away * north;
    }
    /// To the sun, which stands behind the wall, north of it, at this elevation [rad] over the wall's foot.
    dvec3 to_sun(double elevation) const {
        dvec3 const there = glm::normalize(top_edge()), ahead = glm::normalize(glm::cross(there, east));
        return std::cos(elevation) * ahead + std::sin(elevation) * there;
    }
};

/// Where the line from the wall's top away from the sun meets the sphere.
dvec3 shadow_end(Wall const& wall, dvec3 const& to_sun) {
    dvec3 const p = wall.top_edge();
    double const b = glm::dot(p, -to_sun), r = wall.planet.radius;
    return p - to_sun * (-b - std::sqrt(b * b - (glm::dot(p, p) - r * r)));
}

/// How far south of the geometric end [m] the traced shadow ends, by halving between dark and lit ground.
double traced_end(Wall const& wall, double elevation) {
    dvec3 const to_sun = wall.to_sun(elevation), end = shadow_end(wall, to_sun);
    TracedWorld const world(wall.planet, {.to_sun = to_sun}, 1, &wall.scene, wall.placement);
    dvec3 const here = glm::normalize(end), south = glm::normalize(glm::cross(wall.east, here));
    auto const lit = [&](double x) {
        dvec3 const place = glm::normalize(end - x * south) * wall.planet.radius, over = glm::normalize(place);
        return world.tracer.trace(place + 50.0 * over, -over, 0, 1, 0, 1).radiance.x > 0;
    };
    double dark = 20, bright = -20;
    EXPECT_FALSE(lit(dark));
    EXPECT_TRUE(lit(bright));
    while (std::abs(bright - dark) > 1e-5) (lit(0.5 * (dark + bright)) ? bright : dark) = 0.5 * (dark + bright);
    return 0.5 * (dark + bright);
}

} // namespace

TEST(ReferenceShadow, ends_on_the_ground_where_geometry_says) {
    // 100 km from the scene's middle, where single precision is worst.
    for (double const away : {3e3, 1e5}) {
        Wall const wall(planet_of(false), away);
        // A wall that stands this much off moves its shadow by so much over the sine of the sun's height.
        double const error = TerrainMesh::position_error(away + HEIGHT, 4e4);
        for (double const elevation : {3.0, 10.0, 40.0}) {
            double const e = glm::radians(elevation);
            EXPECT_NEAR(traced_end(wall, e), 0, error / std::sin(e)) << away << " m, " << elevation;
        }
    }
}

TEST(ReferenceShadow, a_sun_half_a_degree_higher_shortens_it) {
    Wall const wall(planet_of(false), 3e3);
    dvec3 const low = shadow_end(wall, wall.to_sun(glm::radians(10.0)));
    dvec3 const high = shadow_end(wall, wall.to_sun(glm::radians(10.5)));
    EXPECT_GT(glm::length(low - high),
              10 * TerrainMesh::position_error(3e3 + HEIGHT, 4e4) / std::sin(glm::radians(10.0)));
}

TEST(ReferenceShadow, leaves_the_air_behind_the_wall_dark) {
    Planet const planet = planet_of(true);
    Wall const wall(planet, 3e3);
    SingleScatteringQuadrature const quadrature(planet);
    dvec3 const to_sun = wall.to_sun(glm::radians(10.0)), end = shadow_end(wall, to_sun);
    LightSource const light{.to_sun = to_sun};
    TracedWorld const world(planet, light, 1, &wall.scene, wall.placement), bare(planet, light, 1);
    dvec3 const edge = glm::normalize(glm::cross(wall.east, to_sun)); // across the plane of the shadow's edge
    std::uint64_t seed = 1;
    for (double const x : {0.5, 0.75, 0.95}) {
        dvec3 const foot = glm::mix(end, wall.top_edge(), x), up = glm::normalize(foot), place = planet.radius * up;
        double const dark = glm::dot(wall.top_edge() - place, edge) / glm::dot(up, edge);
        EXPECT_NEAR(dark, x * HEIGHT, 2); // the sphere bends by 0.2 m on the way
        dvec3 const below = glm::exp(-quadrature.depth(place, up, 0, dark));
        dvec3 const exact = below * quadrature({place + dark * up, up, to_sun}).air;
        Measured const m = measure(world.tracer, place, up, 1024, seed++);
        Measured const lit = measure(bare.tracer, place, up, 1024, seed++);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(m.mean[c], exact[c], BOUND * m.deviation[c] + 1e-5 * exact[c]) << x << ", channel " << c;
        }
        EXPECT_GT(lit.mean.z - exact.z, BOUND * std::hypot(lit.deviation.z, m.deviation.z)) << x;
    }
}
