#include "sandbox/stage.h"

#include "core/error.h"
#include "core/log.h"
#include "render/models/models.h"
#include "sandbox/scene_loading.h"

#include <algorithm>
#include <fmt/format.h>

namespace alpenglow {

namespace {

DeviceOptions device_options(DrawOptions const& options, DeviceOptions device) {
    device.index = options.device;
    device.validation = options.validate;
    return device;
}

std::string scene_key(View const& view, Placement const& placement) {
    return fmt::format("{} {} {} {} {} {} {} {} {}", view.scene, view.scene_index.value_or(-1), placement.anchor.latitude, placement.anchor.longitude,
                       placement.anchor.altitude, placement.yaw, placement.scale, placement.curve,
                       view.settings.largest_texture);
}

} // namespace

Stage::Stage(DrawOptions const& options, DeviceOptions device, std::uint32_t frames_in_flight, Switches switches)
    : options_(options), device_(device_options(options, std::move(device))),
      renderer_(device_, frames_in_flight, switches) {}

View Stage::dressed(View view) const {
    if (options_.scene) view.scene = *options_.scene;
    if (options_.scene_index) view.scene_index = options_.scene_index;
    if (options_.planet) view.planet = *options_.planet;
    options_.placement.apply_to(view.placement);
    apply_overrides(view.settings, options_.overrides);
    return view;
}

World Stage::prepare(View const& view) {
    if (planet_name_ != view.planet) {
        planet_ = load_planet(view.planet);
        planet_name_ = view.planet;
        scene_key_.clear();
    }
    // A camera that is inside the planet is found before a scene is loaded, but for the scene's own.
    if (view.scene_camera.empty()) {
        World const world = make_world(view, planet_);
        require_scene(view);
        return world;
    }
    require_scene(view);
    return make_world(with_scene_camera(view, cameras_, planet_.radius), planet_);
}

void Stage::draw(View const& view, World const& world, Extent size, Renderer::Finish const& finish,
                 PresentSync const& sync) {
    std::string const limits = model_limits(world, view.settings, renderer_.scene() != nullptr);
    if (!limits.empty() && said_.insert(limits).second) log_warning(limits);
    try {
        renderer_.draw(world, view.settings, size, finish, sync);
    } catch (Error const& error) {
        // Which images there are only the frame knows.
        if (error.kind() != ErrorKind::wrong_use || overrides("show")) throw;
        throw Error(ErrorKind::bad_input, error.what(), "view " + view.name);
    }
}

bool Stage::overrides(std::string_view setting) const {
    return std::ranges::find(options_.overrides, setting, &Override::name) != options_.overrides.end();
}

void Stage::require_scene(View const& view) {
    Placement const placement = scene_placement(view);
    std::string const key = scene_key(view, placement);
    if (key == scene_key_) return;
    ground_.reset();
    std::optional<Scene> const scene = load_scene(view, planet_.radius);
    renderer_.set_scene(scene ? &*scene : nullptr, placement, planet_.radius);
    cameras_ = scene ? scene->cameras : std::vector<SceneCamera>{};
    if (scene && follows_ground_) ground_.emplace(*scene, placement, planet_.radius);
    scene_key_ = key;
}

double Stage::ground_altitude(glm::dvec3 const& world) const {
    return ground_ ? std::max(ground_->altitude(world).value_or(0), 0.0) : 0.0;
}

void Stage::require_no_messages() const {
    std::vector<std::string> const messages = device_.messages();
    if (messages.empty()) return;
    throw Error(
        ErrorKind::device,
        fmt::format("validation said {} things, the first: {}", messages.size(), messages.front()),
        device_.name());
}

} // namespace alpenglow
