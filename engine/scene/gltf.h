#pragma once

#include "scene/gltf_diagnostic.h"
#include "scene/gltf_limits.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alpenglow {

struct GltfOptions {
    int largest_texture = 4096; ///< [texels] larger pictures are halved until they fit, with a warning
    std::optional<int> scene_index = {}; ///< which of the file's scenes; the file's default unless given
    GltfLimits limits{};
};

/// What a file holds beyond what is drawn.
struct GltfSummary {
    std::vector<std::string> scenes;               ///< names, in the file's order
    int shown_scene = 0;
    std::vector<std::string> extensions;           ///< used; required ones end in " (required)"
    std::size_t animations = 0, skins = 0;
    std::vector<std::string> lights;               ///< kind, name and strength of each
    std::vector<GltfDiagnostic> warnings;          ///< the first 1000: what was left out, changed or is doubtful
};

/// Reads a .gltf or .glb file (by content, not by name). Bytes are checked before and after the parser; warnings go to
/// the log. Throws GltfError. Fills `summary` where one is given, as far as it gets.
Scene load_gltf(std::filesystem::path const& file, GltfOptions const& options = {}, GltfSummary* summary = nullptr);

/// The summary's warnings as they are logged: of each code the first one and how many more there are.
std::vector<std::string> warning_lines(GltfSummary const& summary);

/// Bends a scene made for a flat map plane to a planet: a vertex at horizontal distance d from the origin goes to the
/// same arc length and altitude over the sphere whose top the origin touches. Each instance gets its own bent mesh,
/// with a local origin in its middle. `planet_radius` [m]; `scale` [m per unit of the scene], which stays to be applied
/// by the placement. Throws Error(bad_input) where the scene reaches farther than the planet's other side or its
/// centre.
void curve_to_planet(Scene& scene, double planet_radius, double scale);

} // namespace alpenglow
