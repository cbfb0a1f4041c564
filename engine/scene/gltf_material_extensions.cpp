#include "scene/gltf_material_extensions.h"

#include <cmath>
#include <limits>

namespace alpenglow::gltf {

namespace {

/// Of a dielectric at normal incidence; an index of 0 stands for a perfect mirror (KHR_materials_ior).
double reflectance_of(double ior) {
    double const ratio = (ior - 1) / (ior + 1);
    return ior == 0 ? 1 : ratio * ratio;
}

/// The reflectance for index `ior` and `tint`, one number for all colours, within what the G-buffer holds.
float reflectance_of(double ior, std::vector<double> const& tint, Report& report) {
    double const plain = reflectance_of(ior);
    double mean = 0;
    for (double const channel : tint) mean += std::min(plain * channel, 1.0) / 3;
    if (tint[0] != tint[1] || tint[1] != tint[2])
        report.warn("tinted reflections (KHR_materials_specular) take the mean of their colour");
    if (mean > Material::largest_reflectance)
        report.warn("reflectances above 0.2 (an index of refraction of 2.6) are drawn as 0.2");
    return std::min(static_cast<float>(mean), Material::largest_reflectance);
}

} // namespace

void apply_material_extensions(Material& material, JsonObject const& json, Report& report) {
    if (auto const strong = json.extension("KHR_materials_emissive_strength"))
        material.emission *= static_cast<float>(strong->number("emissiveStrength", 1, 0));

    double ior = 1.5;
    std::vector<double> tint{1, 1, 1};
    auto const refracting = json.extension("KHR_materials_ior");
    auto const specular = json.extension("KHR_materials_specular");
    if (refracting) {
        ior = refracting->number("ior", ior, 0);
        if (ior > 0 && ior < 1) refracting->fail("ior", "must be 0, or 1 and above");
    }
    if (specular) {
        material.specular = static_cast<float>(specular->number("specularFactor", 1, 0, 1));
        tint = specular->numbers("specularColorFactor", tint, 0);
        if (specular->has("specularTexture") || specular->has("specularColorTexture"))
            report.warn("textures of KHR_materials_specular are left out");
    }
    if (refracting || specular) material.reflectance = reflectance_of(ior, tint, report);
    material.unlit = json.extension("KHR_materials_unlit").has_value();
}

int apply_texture_transform(Texture& texture, JsonObject const& info, int uv_set) {
    auto const transform = info.extension("KHR_texture_transform");
    if (!transform) return uv_set;
    auto const offset = transform->numbers("offset", {0, 0}), scale = transform->numbers("scale", {1, 1});
    double const rotation = transform->number("rotation", 0);
    double const c = std::cos(rotation), s = std::sin(rotation);
    // Scaled, then turned counter-clockwise as seen with v pointing down, then moved.
    texture.uv_from_vertex =
        glm::dmat3x2(c * scale[0], -s * scale[0], s * scale[1], c * scale[1], offset[0], offset[1]);
    return static_cast<int>(transform->whole("texCoord", static_cast<std::uint64_t>(uv_set), 0, 1 << 16));
}

int image_of_texture(JsonObject const& texture, std::size_t images, Report& report) {
    if (auto const webp = texture.extension("EXT_texture_webp")) {
        if (int const image = webp->index("source", images); image != no_index) return image;
    }
    int const image = texture.index("source", images);
    if (image != no_index) return image;
    bool const basis = texture.extension("KHR_texture_basisu").has_value();
    report.warn(texture.pointer() +
                (basis ? " has only a KTX2 picture (KHR_texture_basisu), which is not supported: left out"
                       : " has no PNG, JPEG or WebP picture: left out"));
    return no_index;
}

} // namespace alpenglow::gltf
