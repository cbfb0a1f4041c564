#pragma once

#include "atmosphere/sky_irradiance.glsl"

#include <vector>

namespace alpenglow::test {

/// Earth's air: Bruneton's and Hillaire's coefficients at 680, 550 and 440 nm.
inline shader::Atmosphere earth_air() {
    shader::Atmosphere air{};
    air.ground_radius = 6.36e6f;
    air.top_altitude = 1e5f;
    air.rayleigh_scattering = {5.802e-6f, 13.558e-6f, 33.1e-6f};
    air.rayleigh_scale_height = 8000;
    air.aerosol_scattering = glm::vec3(3.996e-6f);
    air.aerosol_scale_height = 1200;
    air.aerosol_extinction = glm::vec3(4.44e-6f);
    air.aerosol_g = 0.8f;
    air.ozone_absorption = {0.65e-6f, 1.881e-6f, 0.085e-6f};
    air.ozone_centre = 25000;
    air.ozone_half_width = 15000;
    air.ground_albedo = glm::vec3(0.2f);
    air.solar_irradiance = glm::vec3(1);
    air.sun_angular_radius = 0.004675f;
    return air;
}

/// Fernández Arenas' hazy Earth.
inline shader::Atmosphere hazy_air() {
    shader::Atmosphere air = earth_air();
    air.aerosol_scattering = glm::vec3(2e-5f);
    air.aerosol_extinction = glm::vec3(2e-5f / 0.9f);
    air.aerosol_g = 0.76f;
    return air;
}

/// Sakmary's fictional dense planet, his table 5.4.
inline shader::Atmosphere dense_air() {
    shader::Atmosphere air = earth_air();
    air.rayleigh_scattering = {0.149e-3f, 0.142e-3f, 0.051e-3f};
    air.rayleigh_scale_height = 18416;
    air.aerosol_scattering = {0.046e-3f, 0.047e-3f, 0.057e-3f};
    air.aerosol_extinction = {0.082e-3f, 0.071e-3f, 0.058e-3f};
    air.aerosol_scale_height = 13143;
    return air;
}

/// Nothing there at all.
inline shader::Atmosphere no_air() {
    shader::Atmosphere air = earth_air();
    air.rayleigh_scattering = air.aerosol_scattering = air.aerosol_extinction = air.ozone_absorption = glm::vec3(0);
    return air;
}

/// A table as a pass fills it: `texel(uv)` for each texel's centre.
class Table {
public:
    template <typename Texel> Table(int width, int height, Texel const& texel) : width_(width), height_(height) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                texels_.push_back(
                    texel(glm::vec2((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height))));
    }
    shader::sampler2D sampler() const { return {width_, height_, texels_.data()}; }
    std::vector<glm::vec4> const& texels() const { return texels_; }

private:
    int width_, height_;
    std::vector<glm::vec4> texels_;
};

inline Table make_transmittance_table(shader::Atmosphere const& air) {
    return {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT, [&](glm::vec2 uv) {
                glm::vec2 const node = shader::transmittance_altitude_mu_from_uv(air, uv);
                return shader::optical_depth_texel(shader::compute_optical_depth_to_top(air, node.x, node.y));
            }};
}

inline Table make_multiple_scattering_table(shader::Atmosphere const& air, Table const& transmittance) {
    return {MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT, [&](glm::vec2 uv) {
                glm::vec2 const node =
                    shader::altitude_sun_from_uv(air, uv, MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT);
                return shader::multiple_scattering_texel(
                    shader::compute_multiple_scattering(air, transmittance.sampler(), node.x, node.y));
            }};
}

/// The clear Earth's tables, built once.
inline Table const& earth_transmittance() {
    static Table const table = make_transmittance_table(earth_air());
    return table;
}
inline Table const& earth_multiple_scattering() {
    static Table const table = make_multiple_scattering_table(earth_air(), earth_transmittance());
    return table;
}

} // namespace alpenglow::test
