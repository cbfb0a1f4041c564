#include "sandbox/traced_view.h"

#include "sandbox/scene_loading.h"

namespace alpenglow {

namespace {

LightSource light_of(World const& world, SunShape shape) {
    return {.to_sun = world.to_sun,
            .angular_radius = shape == SunShape::disc ? world.planet.sun_angular_radius : 0,
            .irradiance = world.planet.solar_irradiance};
}

std::vector<SceneCamera> cameras_of(std::optional<Scene> const& scene) {
    return scene ? scene->cameras : std::vector<SceneCamera>{};
}

} // namespace

TracedView::TracedView(View const& view, SunShape sun, int orders)
    : TracedView(view, load_planet(view.planet), sun, orders) {}

TracedView::TracedView(View const& view, Planet const& planet, SunShape sun, int orders)
    : scene_(load_scene(view, planet.radius)),
      world_(make_world(with_scene_camera(view, cameras_of(scene_), planet.radius), planet)),
      ground_(world_.planet, scene_ ? &*scene_ : nullptr, scene_placement(view)),
      tracer_(make_medium(world_.planet), ground_, light_of(world_, sun), {.orders = orders}) {}

} // namespace alpenglow
