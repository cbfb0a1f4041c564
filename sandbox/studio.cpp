#include "scene/studio.h"

#include "core/error.h"
#include "core/files.h"
#include "core/log.h"
#include "core/progress.h"
#include "image/bitmap_text.h"
#include "image/codec.h"
#include "image/contact_sheet.h"
#include "sandbox/stage.h"
#include "scene/gltf.h"

#include <algorithm>
#include <fmt/format.h>

namespace alpenglow {

namespace {

constexpr std::uint32_t WIDEST_SHEET = 3200; // [pixels] pictures are made smaller beyond

bool is_scene(std::filesystem::path const& file) { return file.extension() == ".gltf" || file.extension() == ".glb"; }

/// Files as they come, and every scene below a folder, by name.
std::vector<std::filesystem::path> scene_files(std::vector<std::filesystem::path> const& given) {
    std::vector<std::filesystem::path> files;
    for (std::filesystem::path const& path : given) {
        if (!std::filesystem::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        auto const begin = static_cast<std::ptrdiff_t>(files.size());
        for (auto const& entry : std::filesystem::recursive_directory_iterator(path)) {
            if (is_scene(entry.path())) files.push_back(entry.path());
        }
        std::sort(files.begin() + begin, files.end());
    }
    if (!files.empty()) return files;
    throw Error(ErrorKind::bad_input, "holds no .gltf or .glb file", given.front().string(), "name another folder");
}

/// A picture that says why there is none.
ByteImage label(Extent size, std::string_view text) {
    constexpr std::uint32_t paper = 0x3a2a26, ink = 0xf0c0a0;
    constexpr int margin = 6; // [pixels]
    ByteImage picture(size);
    fill_rectangle(picture, 0, 0, static_cast<int>(size.width), static_cast<int>(size.height), paper);
    int top = margin;
    for (std::string const& line : wrap_text(text, 1, static_cast<int>(size.width) - 2 * margin)) {
        draw_text(picture, margin, top, line, ink, 1);
        top += TEXT_LINE_HEIGHT;
    }
    return picture;
}

ByteImage picture_of(Stage& stage, StudioOptions const& options, std::filesystem::path const& file) {
    Settings settings = studio_settings();
    apply_overrides(settings, options.overrides);
    Scene const scene = load_gltf(file, {.largest_texture = settings.largest_texture,
                                         .scene_index = options.scene_index,
                                         .limits = gltf_limits(settings)});
    if (scene.bounds.empty()) return label(options.size, "the scene holds no triangle");
    StudioShot const shot =
        make_studio_shot(scene.bounds, static_cast<double>(options.size.width) / options.size.height);
    stage.renderer().set_scene(&scene, shot.placement, shot.world.planet.radius);
    stage.renderer().draw(shot.world, settings, options.size);
    return stage.renderer().picture();
}

/// Without the file's name, which stands below the picture.
std::string reason(Error const& error, std::filesystem::path const& file) {
    std::string const line = error.what(), start = file.string() + ": ";
    return line.starts_with(start) ? line.substr(start.size()) : line;
}

} // namespace

int studio(StudioOptions const& options) {
    std::vector<std::filesystem::path> const files = scene_files(options.scenes);
    require_writable_folder(options.out.parent_path());
    Stage stage(options);
    ContactSheet sheet(files.size(), options.size, WIDEST_SHEET);
    Progress progress("rendering", files.size());
    std::optional<Error> refused;
    std::size_t drawn = 0;
    for (std::filesystem::path const& file : files) {
        std::string const name = file.stem().string();
        progress.update(static_cast<std::size_t>(&file - files.data()), name);
        try {
            sheet.add(picture_of(stage, options, file), name);
            ++drawn;
        } catch (Error const& error) {
            if (error.kind() != ErrorKind::bad_input) throw;
            if (!refused) refused = error;
            log_warning(error.what());
            sheet.add(label(options.size, reason(error, file)), name);
        }
    }
    progress.update(files.size());
    if (drawn == 0) throw *refused;
    stage.require_no_messages();
    write_png(options.out, sheet.picture());
    fmt::print("{}\n", options.out.string());
    return 0;
}

} // namespace alpenglow
