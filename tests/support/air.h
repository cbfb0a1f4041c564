#pragma once

#include "atmosphere/sky_irradiance.glsl"
#include "render/atmosphere_constants.h"
#include "support/components.h"

#include <vector>

namespace alpenglow::test {

/// Clear Earth's air.
inline shader::Atmosphere earth_air() { return atmosphere_of(make_earth()); }
inline shader::Atmosphere hazy_air() { return atmosphere_of(hazy_planet()); }
inline shader::Atmosphere dense_air() { return atmosphere_of(dense_planet()); }

/// Nothing there at all.
inline shader::Atmosphere no_air() {
    Planet planet = make_earth();
    planet.air.components.clear();
    return atmosphere_of(planet);
}

/// Molecules alone, `factor` times as many as Earth has.
inline shader::Atmosphere molecules(double factor) {
    Planet planet = make_earth();
    planet.air.components.resize(1);
    planet.air.components[0].scattering *= factor;
    return atmosphere_of(planet);
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
