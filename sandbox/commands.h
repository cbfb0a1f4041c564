#pragma once

#include "core/extent.h"
#include "core/settings.h"
#include "scene/scene.h"
#include "terrain/terrain.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alpenglow {

/// `--set NAME=VALUE`, in the order given; laid over what the view or flight file says.
struct Override {
    std::string name, value;

    bool operator==(Override const&) const = default;
};

/// Throws Error(wrong_use) for a name that does not exist or a value that it does not take.
void apply_overrides(Settings& settings, std::span<Override const> overrides);

/// What `--at`, `--yaw`, `--scale` and `--curve` say of where the scene stands; each is laid over the file's by itself.
struct PlacementOptions {
    std::optional<Geodetic> at;
    std::optional<double> yaw; ///< [rad] clockwise seen from above
    std::optional<double> scale;
    bool curve = false;

    /// Leaves `placement` alone where none of the options was given.
    void apply_to(std::optional<Placement>& placement) const;
};

/// The options that every command which draws has.
struct DrawOptions {
    std::optional<std::string> scene;  ///< path, "default", or empty text for none
    std::optional<int> scene_index;    ///< which of the file's scenes
    std::optional<std::string> planet; ///< name in assets/planets, or a path
    PlacementOptions placement;
    std::vector<Override> overrides;
    std::optional<int> device; ///< index as `devices` prints it
    bool validate = false;     ///< Vulkan validation; a message fails the command
};

struct FlyOptions : DrawOptions {
    std::optional<std::filesystem::path> flight;
    bool headless = false;
    std::optional<Extent>
        size; ///< else 1280x720 in a window, 960x540 without: the flight is to be done within two minutes on two cores
    int frames = 24;
    std::filesystem::path out = "out/flight";
};

struct RenderOptions : DrawOptions {
    std::vector<std::filesystem::path> views; ///< at least one
    Extent size{1280, 720};
    std::filesystem::path out = "out/render";
    bool png = true, exr = false; ///< at least one
};

struct StudioOptions : DrawOptions {
    std::vector<std::filesystem::path> scenes; ///< at least one: glTF files, and folders of them
    Extent size{320, 320};                     ///< of each scene's picture
    std::filesystem::path out = "out/studio.png";
};

struct BenchOptions : DrawOptions {
    std::vector<std::filesystem::path> views; ///< at least one, but for `load`, `plot` and `switches`
    /// glTF file whose loading is measured in place of views; an empty path: a scene that is made for it.
    std::optional<std::filesystem::path> load;
    static constexpr Extent SIZE{1280, 720}, SWITCHES_SIZE{320, 180};
    std::optional<Extent> size; ///< else one of those
    int frames = 10;            ///< measured, after warm-up; rounds of `load` and `switches`
    bool json = false;
    /// SVG file for each model's error against its cost, measured in place of the passes; without views, in three of the
    /// comparison's.
    std::optional<std::filesystem::path> plot;
    bool switches = false; ///< how long changes of settings take while it flies, in place of the passes
};

struct CompareOptions {
    std::filesystem::path test, reference;
    std::optional<double> exposure; ///< [stops] of the pictures that LDR FLIP compares; 0 unless given
    std::optional<std::filesystem::path> heatmap;
    bool json = false;
};

/// Every model of the air.
inline constexpr std::string_view ALL_MODELS = "all";

struct EvaluateOptions : DrawOptions {
    std::vector<std::filesystem::path> views;         ///< empty: all of assets/views/comparison
    std::vector<std::string> models;                  ///< names, or ALL_MODELS; empty: all
    std::optional<std::filesystem::path> references;  ///< folder; assets/references unless given
    bool json = false;
    std::optional<std::filesystem::path> heatmaps; ///< folder
    std::optional<std::filesystem::path> document; ///< Markdown file to write
    std::optional<std::filesystem::path> check;    ///< such a file, whose figures must still hold
};

struct ShaftsOptions : DrawOptions {
    std::vector<std::filesystem::path> views; ///< empty: all of assets/views/shafts
    Extent size{640, 360};
    bool json = false;
    std::optional<std::filesystem::path> heatmaps; ///< folder
    std::optional<std::filesystem::path> document; ///< Markdown file with a section for the table
    std::optional<std::filesystem::path> plot;     ///< SVG file
};

struct TerrainCommandOptions {
    TerrainOptions terrain;
    std::filesystem::path out = "out/terrain/terrain.gltf";
};

/// Writes the scenes of the shafts' tests.
struct ScenesOptions {
    std::filesystem::path out = "out/scenes"; ///< folder
};

struct ReferenceOptions {
    std::vector<std::filesystem::path> views; ///< at least one
    /// Paths for each pixel, at most where `noise` is given; rounded up to whole passes, two at least.
    int samples = 4096;
    double noise = 0;   ///< HDR-FLIP between two halves at which a view is done; 0: after all samples
    int orders = 0;     ///< events between sun and camera; 0: any number
    bool point_sun = false;
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: one for each core
    Extent size{320, 180};
    std::filesystem::path out = "out/reference";
    bool resume = false;
};

struct InspectOptions {
    std::filesystem::path scene;
    std::optional<int> scene_index; ///< which of the file's scenes
    bool json = false;
};

struct DevicesOptions {};

/// Each returns the exit code, and throws Error.
int fly(FlyOptions const& options);
int render(RenderOptions const& options);
int studio(StudioOptions const& options);
int bench(BenchOptions const& options);
int compare(CompareOptions const& options);
int evaluate(EvaluateOptions const& options);
int shafts(ShaftsOptions const& options);
int terrain(TerrainCommandOptions const& options);
int scenes(ScenesOptions const& options);
int reference(ReferenceOptions const& options);
int inspect(InspectOptions const& options);
int devices(DevicesOptions const& options);

} // namespace alpenglow
