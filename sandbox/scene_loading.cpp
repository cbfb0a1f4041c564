#include "sandbox/scene_loading.h"

#include "scene/gltf.h"
#include "terrain/terrain.h"

namespace alpenglow {

std::optional<Scene> load_scene(View const& view, double planet_radius) {
    if (view.scene.empty()) return std::nullopt;
    std::filesystem::path const file =
        view.scene == "default" ? default_terrain(planet_radius) : std::filesystem::path(view.scene);
    Scene scene = load_gltf(file, {.largest_texture = view.settings.largest_texture,
                                   .scene_index = view.scene_index,
                                   .limits = gltf_limits(view.settings)});
    Placement const placement = scene_placement(view);
    if (placement.curve) curve_to_planet(scene, planet_radius, placement.scale);
    return scene;
}

} // namespace alpenglow
