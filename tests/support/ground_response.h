#pragma once

#include "atmosphere/ground_response.glsl"
#include "support/air.h"

namespace alpenglow::test {

/// The table of pass `ground_response`, as it stands after so many rounds without extrapolation.
class ResponseTable {
public:
    ResponseTable(shader::Atmosphere const& air, int rounds) : texels_(LIGHT_TILES * ROWS) {
        for (int round = 0; round < rounds; ++round) {
            std::vector<NodeMoments> nodes;
            for (std::size_t row = 0; row < ROWS; ++row) nodes.push_back(gathered(air, int(row), round == 0));
            for (std::size_t row = 0; row < ROWS; ++row) store(row, nodes[row]);
        }
    }
    shader::sampler2D sampler() const { return {1, LIGHT_TILES * ROWS, texels_.data()}; }

    static constexpr std::size_t ROWS = MULTIPLE_SCATTERING_HEIGHT;

private:
    NodeMoments gathered(shader::Atmosphere const& air, int row, bool first) const {
        shader::GatherRays const rays = shader::GROUND_RESPONSE_RAYS;
        glm::vec2 const node(shader::ground_response_altitude(air, row), 1);
        NodeMoments sum = gather_moments(air, rays, node, [&](shader::AirRay const& ray) {
            return shader::light_over_bright_ground(air, sampler(), ray, rays.cells, first);
        });
        for (shader::Moments& channel : sum) channel = shader::zonal_moments(channel);
        return sum;
    }
    void store(std::size_t row, NodeMoments const& moments) {
        for (std::size_t c = 0; c < 3; ++c) {
            shader::Moments const packed = shader::packed_moments(moments[c]);
            for (std::size_t i = 0; i < LIGHT_PARTS; ++i) texels_[(LIGHT_PARTS * c + i) * ROWS + row] = packed.part[i];
        }
    }
    std::vector<glm::vec4> texels_;
};

} // namespace alpenglow::test
