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

/// Reflectance for index `ior` and `tint`: one number for all colours.
void apply_reflectance(Material& material, double ior, std::vector<double> const& tint, Report& report) {
    double const plain = reflectance_of(ior);
    glm::dvec3 colors(0);
    for (int c = 0; c < 3; ++c) colors[c] = std::min(plain * tint[static_cast<std::size_t>(c)], 1.0);
    double const sum = colors.r + colors.g + colors.b;
    if (sum > 0) material.reflectance_shares = colors / sum;
    material.reflectance = static_cast<float>(sum / 3);
    if (tint[0] != tint[1] || tint[1] != tint[2] || material.reflectance_texture)
        report.warn("tinted reflections (KHR_materials_specular) take the mean of their colour");
    if (sum / 3 <= Material::largest_reflectance) return;
    report.warn("reflectances above 0.2 (an index of refraction of 2.6) are drawn as 0.2");
    // What a texture may lower stays as it is.
    if (!material.reflectance_texture) material.reflectance = Material::largest_reflectance;
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
    }
    if (refracting || specular) apply_reflectance(material, ior, tint, report);
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
