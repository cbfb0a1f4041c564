#include "support/render_test.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alpenglow::test {

namespace {

std::unique_ptr<Renderer>& shared_renderer() {
    static std::unique_ptr<Renderer> renderer;
    return renderer;
}

} // namespace

Camera Stand::camera(glm::dvec3 const& eye, glm::dvec3 const& target, double fov, glm::dvec3 const& up) const {
    glm::dvec3 const back = glm::normalize(eye - target), right = glm::normalize(glm::cross(up, back));
    return {world(eye), glm::dmat3(world_from_scene()) * glm::dmat3(right, glm::cross(back, right), back), fov};
}

glm::dvec3 sun_at(double elevation, double azimuth) {
    double const e = glm::radians(elevation), a = glm::radians(azimuth);
    return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

Stand stand_on(Planet const& planet, double altitude) {
    Stand stand{planet, {}};
    stand.placement.anchor = {default_anchor.latitude, default_anchor.longitude, altitude};
    return stand;
}

Planet airless_planet() {
    Planet planet;
    planet.name = "airless";
    planet.has_air = false;
    planet.look = GroundLook::uniform;
    planet.ground_albedo = glm::dvec3(0.12);
    return planet;
}

Settings plain_settings() {
    Settings settings;
    settings.dither = false;
    settings.sun_disc = settings.stars = settings.ambient_occlusion = false;
    return settings;
}

glm::dvec3 pixel_direction(Camera const& camera, Extent extent, double x, double y) {
    double const ty = std::tan(0.5 * camera.vertical_fov), tx = ty * extent.width / extent.height;
    double const right = (2 * (x + 0.5) / extent.width - 1) * tx, up = (1 - 2 * (y + 0.5) / extent.height) * ty;
    return glm::normalize(camera.world_from_camera * glm::dvec3(right, up, -1));
}

int difference(ByteImage const& a, ByteImage const& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(int(a.rgba[i]) - int(b.rgba[i])));
    return most;
}

Renderer& RenderTest::renderer() {
    std::unique_ptr<Renderer>& renderer = shared_renderer();
    if (!renderer) {
        renderer = std::make_unique<Renderer>(device());
        at_end_of_tests([] { shared_renderer().reset(); });
    }
    return *renderer;
}

void RenderTest::SetUp() {
    GpuTest::SetUp();
    renderer().set_scene(nullptr, {}, 1);
}

FloatImage RenderTest::radiance(World const& world, Settings const& settings, Extent extent) {
    renderer().draw(world, settings, extent);
    return renderer().radiance();
}

std::vector<double> RenderTest::visibility(World const& world, Settings const& settings, Extent extent) {
    Settings without = settings;
    without.shadows = false;
    return visibility(world, settings, radiance(world, without, extent));
}

std::vector<double> RenderTest::visibility(World const& world, Settings const& settings, FloatImage const& lit) {
    FloatImage const shaded = radiance(world, settings, lit.extent);
    std::vector<double> result;
    for (std::size_t i = 0; i < lit.extent.pixels(); ++i) result.push_back(shaded.rgba[4 * i] / lit.rgba[4 * i]);
    return result;
}

ByteImage RenderTest::picture(World const& world, Settings const& settings, Extent extent) {
    renderer().draw(world, settings, extent);
    return renderer().picture();
}

} // namespace alpenglow::test
