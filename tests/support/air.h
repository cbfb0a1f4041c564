#pragma once

#include "atmosphere/inscattering.glsl"

#include <array>
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
    air.phase_moments[RAYLEIGH_MOMENTS] = {{1.0f, 0.0f, 0.1f, 0.0f, 0.0f}};
    air.phase_moments[AEROSOL_MOMENTS] = {{0.8928f, 0.7370f, 0.6028f, 0.4702f, 0.3577f}};
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

/// Eight moments of the light at a node, each channel's low degrees and high ones.
using NodeMoments = std::array<shader::ChannelMoments, 3>;

/// The sum over a node's directions, as a workgroup of the passes makes it. `light(ray)` is the radiance along a ray.
template <typename Light>
NodeMoments gather_moments(shader::Atmosphere const& air, shader::GatherRays rays, glm::vec2 node, Light const& light) {
    NodeMoments sum{};
    for (int i = 0; i < shader::gather_count(rays); ++i) {
        shader::GatherDirection const d = shader::gather_direction(air, rays, node.x, node.y, i);
        glm::vec3 const radiance =
            light(shader::make_air_ray(air.ground_radius, node.x, d.mu, node.y, d.sunward.nu)) * d.weight;
        shader::MomentBasis const basis = shader::moment_basis(d.sunward);
        for (int channel = 0; channel < 3; ++channel) {
            sum[std::size_t(channel)].low += basis.low * radiance[channel];
            sum[std::size_t(channel)].high += basis.high * radiance[channel];
        }
    }
    return sum;
}

/// The table of moments: each round adds an order of scattering.
class LightTable {
public:
    LightTable(shader::Atmosphere const& air, shader::sampler2D transmittance, shader::GatherRays first)
        : first_order_(nodes()), texels_(nodes() * LIGHT_TILES) {
        for (std::size_t i = 0; i < nodes(); ++i) {
            first_order_[i] = gather_moments(air, first, place(air, i), [&](shader::AirRay const& ray) {
                return shader::first_order_light(air, transmittance, ray, first.cells);
            });
            store(i, first_order_[i]);
        }
    }
    void add_order(shader::Atmosphere const& air, shader::GatherRays higher) {
        std::vector<NodeMoments> sums = first_order_;
        for (std::size_t i = 0; i < nodes(); ++i) {
            NodeMoments const again = gather_moments(air, higher, place(air, i), [&](shader::AirRay const& ray) {
                return shader::scattered_light(air, sampler(), ray, higher.cells);
            });
            for (std::size_t c = 0; c < 3; ++c) sums[i][c].low += again[c].low, sums[i][c].high += again[c].high;
        }
        for (std::size_t i = 0; i < nodes(); ++i) store(i, sums[i]);
    }
    shader::sampler2D sampler() const {
        return {MULTIPLE_SCATTERING_WIDTH, LIGHT_TILES * MULTIPLE_SCATTERING_HEIGHT, texels_.data()};
    }
    std::vector<glm::vec4> const& texels() const { return texels_; }

    static std::size_t nodes() { return std::size_t(MULTIPLE_SCATTERING_WIDTH * MULTIPLE_SCATTERING_HEIGHT); }
    /// x = altitude [m], y = mu_s.
    static glm::vec2 place(shader::Atmosphere const& air, std::size_t node) {
        float const x = float(node % MULTIPLE_SCATTERING_WIDTH) + 0.5f, y = float(node / MULTIPLE_SCATTERING_WIDTH) + 0.5f;
        return shader::altitude_sun_from_uv(air, {x / MULTIPLE_SCATTERING_WIDTH, y / MULTIPLE_SCATTERING_HEIGHT},
                                            MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT);
    }

private:
    void store(std::size_t node, NodeMoments const& moments) {
        for (std::size_t c = 0; c < 3; ++c) {
            shader::ChannelMoments const packed = shader::packed_moments(moments[c]);
            texels_[2 * c * nodes() + node] = packed.low;
            texels_[(2 * c + 1) * nodes() + node] = packed.high;
        }
    }
    std::vector<NodeMoments> first_order_;
    std::vector<glm::vec4> texels_;
};

/// The clear Earth's tables, built once.
inline Table const& earth_transmittance() {
    static Table const table = make_transmittance_table(earth_air());
    return table;
}
} // namespace alpenglow::test
