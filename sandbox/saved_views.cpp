#include "sandbox/saved_views.h"

#include "core/files.h"
#include "image/codec.h"

#include <fmt/format.h>

namespace alpenglow {

namespace {

std::filesystem::path free_stem(std::filesystem::path const& folder) {
    for (int number = 1;; ++number) {
        std::filesystem::path const stem = folder / fmt::format("view_{:04}", number);
        if (!std::filesystem::exists(stem.string() + ".json") && !std::filesystem::exists(stem.string() + ".png"))
            return stem;
    }
}

} // namespace

std::filesystem::path save_view(std::filesystem::path const& folder, View view, ByteImage const& picture) {
    require_writable_folder(folder);
    // The view file lies elsewhere than where a relative path started.
    if (!view.scene.empty() && view.scene != "default") view.scene = std::filesystem::absolute(view.scene);
    if (view.planet.find('/') != std::string::npos || view.planet.ends_with(".json"))
        view.planet = std::filesystem::absolute(view.planet);
    std::filesystem::path const stem = free_stem(folder);
    write_png(stem.string() + ".png", picture);
    write_text_file(stem.string() + ".json", view_text(view));
    return stem.string() + ".json";
}

} // namespace alpenglow
