#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_report.h"

#include <functional>

namespace alpenglow::gltf {

/// Decodes the pictures that `materials` use, each once, and turns `Texture::picture` into indices of the result.
/// Pictures wider or higher than `largest` texels are halved until they fit. `decoded` is called for each, on any
/// thread. Throws Error(bad_input).
std::vector<Picture> load_pictures(Document const& document, std::vector<Material>& materials, int largest,
                                   Report& report, std::function<void()> const& decoded);

} // namespace alpenglow::gltf
