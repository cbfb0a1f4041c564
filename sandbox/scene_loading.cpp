#include "sandbox/scene_loading.h"

#include "core/progress.h"
#include "scene/gltf.h"
#include "terrain/terrain.h"

namespace alpenglow {

namespace {

/// With a bar where it takes more than a second.
Scene load_with_progress(std::filesystem::path const& file, GltfOptions options) {
    constexpr std::size_t percent = 100;
    Progress progress("loading", percent, 0, std::chrono::seconds(1));
    options.progress = [&](std::size_t done, std::size_t steps) { progress.update(percent * done / steps); };
    return load_gltf(file, options);
}

} // namespace

std::optional<Scene> load_scene(View const& view, double planet_radius) {
    if (view.scene.empty()) return std::nullopt;
    std::filesystem::path const file =
        view.scene == "default" ? default_terrain(planet_radius) : std::filesystem::path(view.scene);
    Scene scene = load_with_progress(file, {.largest_texture = view.settings.largest_texture,
                                            .scene_index = view.scene_index,
                                            .limits = gltf_limits(view.settings)});
    Placement const placement = scene_placement(view);
    if (placement.curve) curve_to_planet(scene, planet_radius, placement.scale, view.settings.most_vertices);
    return scene;
}

} // namespace alpenglow
