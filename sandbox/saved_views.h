#pragma once

#include "image/image.h"
#include "scene/view.h"

#include <filesystem>

namespace alpenglow {

/// Writes view_NNNN.png and view_NNNN.json beside each other, NNNN the first number that is free in the folder, and
/// gives the path of the view file. `alpenglow render` makes the picture again from it. Throws Error(bad_input).
std::filesystem::path save_view(std::filesystem::path const& folder, View view, ByteImage const& picture);

} // namespace alpenglow
