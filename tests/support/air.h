#pragma once

#include "atmosphere/inscattering.glsl"
#include "render/atmosphere_constants.h"
#include "support/components.h"

#include <array>
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

inline Table make_sunlight_table(shader::Atmosphere const& air) {
    Table const transmittance = make_transmittance_table(air);
    return {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT, [&](glm::vec2 uv) {
                glm::vec2 const node = shader::transmittance_altitude_mu_from_uv(air, uv);
                return shader::optical_depth_texel(shader::compute_sunlight_depth(transmittance.sampler(), air, node.x, node.y));
            }};
}

/// Moments of the light at a node, of each channel.
using NodeMoments = std::array<shader::Moments, 3>;

/// The sum over a node's directions, as a workgroup of the passes makes it. `light(ray)` is the radiance along a ray.
template <typename Light>
NodeMoments gather_moments(shader::Atmosphere const& air, shader::GatherRays rays, glm::vec2 node, Light const& light) {
    NodeMoments sum{};
    for (int i = 0; i < shader::gather_count(rays); ++i) {
        shader::GatherDirection const d = shader::gather_direction(air, rays, node.x, node.y, i);
        glm::vec3 const radiance =
            light(shader::make_air_ray(air.ground_radius, node.x, d.mu, node.y, d.sunward.nu)) * d.weight;
        shader::Moments const basis = shader::gather_basis(d);
        for (int channel = 0; channel < 3; ++channel)
            sum[std::size_t(channel)] = shader::sum_of(sum[std::size_t(channel)], shader::scaled(basis, radiance[channel]));
    }
    return sum;
}

/// The table of moments: each round adds an order of scattering.
class LightTable {
public:
    LightTable(shader::Atmosphere const& air, shader::sampler2D sunlight, shader::GatherRays first)
        : first_order_(nodes()), texels_(nodes() * LIGHT_TILES) {
        for (std::size_t i = 0; i < nodes(); ++i) {
            first_order_[i] = gather_moments(air, first, place(air, i), [&](shader::AirRay const& ray) {
                return shader::first_order_light(air, sunlight, ray, first.cells);
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
            for (std::size_t c = 0; c < 3; ++c) sums[i][c] = shader::sum_of(sums[i][c], again[c]);
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
            shader::Moments const packed = shader::packed_moments(moments[c]);
            for (std::size_t i = 0; i < LIGHT_PARTS; ++i) texels_[(LIGHT_PARTS * c + i) * nodes() + node] = packed.part[i];
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
inline Table const& earth_sunlight() {
    static Table const table = make_sunlight_table(earth_air());
    return table;
}
} // namespace alpenglow::test
