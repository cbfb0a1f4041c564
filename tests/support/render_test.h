#pragma once

#include "render/renderer.h"
#include "support/gpu_test.h"
#include "support/scenes.h"

namespace alpenglow::test {

/// Where a small scene stands, and how it is looked at, all in the scene's own axes, so that the same numbers serve anywhere
/// on a planet.
struct Stand {
    Planet planet{};
    Placement placement{};

    glm::dmat4 world_from_scene() const { return alpenglow::world_from_scene(placement, planet.radius); }
    glm::dvec3 world(glm::dvec3 const& place) const { return glm::dvec3(world_from_scene() * glm::dvec4(place, 1)); }
    glm::dvec3 world_direction(glm::dvec3 const& direction) const { return glm::dmat3(world_from_scene()) * direction; }
    /// A camera at `eye` that looks at `target`, with `up` up in its picture; `fov` [rad], vertical.
    Camera camera(glm::dvec3 const& eye, glm::dvec3 const& target, double fov, glm::dvec3 const& up = {0, 1, 0}) const;
    World view(Camera const& camera, glm::dvec3 const& to_sun) const { return {planet, camera, glm::normalize(world_direction(to_sun))}; }
};

/// Unit vector in scene axes; elevation and azimuth (clockwise from north, which is -Z) in degrees.
glm::dvec3 sun_at(double elevation, double azimuth);

/// In the Alps, `altitude` [m] above the planet's radius.
Stand stand_on(Planet const& planet, double altitude = 0);

/// Earth's size, and no air.
Planet airless_planet();

/// Settings that tests share: nothing that hides an error.
Settings plain_settings();

/// The unit direction of a pixel's centre, in world axes.
glm::dvec3 pixel_direction(Camera const& camera, Extent extent, double x, double y);

/// The largest of a channel, in 255ths, between pictures of one size.
int difference(ByteImage const& a, ByteImage const& b);

/// A test that draws whole frames. All tests of a program share one renderer.
class RenderTest : public GpuTest {
protected:
    static Renderer& renderer();
    void put(Scene const& scene, Stand const& stand) { renderer().set_scene(&scene, stand.placement, stand.planet.radius); }
    void SetUp() override;

    FloatImage radiance(World const& world, Settings const& settings, Extent extent);
    /// How much of the sun each pixel's surface sees, 0 to 1, by a picture without shadows.
    std::vector<double> visibility(World const& world, Settings const& settings, Extent extent);
    /// The same, where that picture is there.
    std::vector<double> visibility(World const& world, Settings const& settings, FloatImage const& lit);
    ByteImage picture(World const& world, Settings const& settings, Extent extent);
};

inline glm::vec3 pixel(FloatImage const& image, std::uint32_t x, std::uint32_t y) { return {image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]}; }

} // namespace alpenglow::test
