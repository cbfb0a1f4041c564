#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_source.h"

namespace alpenglow::gltf {

/// The bytes of every buffer: from the .glb's chunk, from data URIs, or from files in the scene's folder and nowhere
/// else. Throws Error(bad_input) where one is missing or shorter than its byteLength.
std::vector<std::vector<std::byte>> read_buffers(Source& source, Report& report);

/// The encoded bytes (PNG or JPEG) of picture `image`. Throws Error(bad_input).
std::vector<std::byte> read_image_bytes(Document const& document, std::size_t image, Report const& report);

} // namespace alpenglow::gltf
