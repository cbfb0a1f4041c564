#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_json.h"

namespace alpenglow::gltf {

/// KHR_materials_emissive_strength, _ior, _specular and _unlit of a material whose core and textures are read already.
/// Reflectance is one number: a tint of it is averaged, with a warning. Throws Error(bad_input).
void apply_material_extensions(Material& material, JsonObject const& json, Report& report);

/// KHR_texture_transform of a texture reference ("textureInfo"): how it turns coordinates and, where it says so, which
/// set it takes; `uv_set` otherwise. Throws Error(bad_input).
int apply_texture_transform(Texture& texture, JsonObject const& info, int uv_set);

/// The image of texture `texture`: WebP before the core's PNG or JPEG; no_index, with a warning, where it has none that
/// can be read. Throws Error(bad_input).
int image_of_texture(JsonObject const& texture, std::size_t images, Report& report);

} // namespace alpenglow::gltf
