#include "encoding/octahedral.glsl"
#include "scene/gltf.h"
#include "support/deep_png.h"
#include "support/gltf_builder.h"
#include "support/render_test.h"

#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent SMALL{16, 8};
constexpr double DISTANCE = 10, HALF_WIDTH = 3 * DISTANCE; // [m]
constexpr int FIRST = 32768, STEP = 4;                     // of the normal map's x: 256 texels, four steps of 8 bits

/// A wall that hangs over the origin and faces it, u to the east, with a normal map that leans more and more to the
/// east.
Scene leaning_wall() {
    DeepImage map = deep_gradient({256, 1}, FIRST, STEP);
    for (std::uint32_t x = 0; x < 256; ++x) map.at(x, 0)[1] = 32768, map.at(x, 0)[2] = 65535;
    GltfBuilder builder;
    constexpr float d = DISTANCE, w = HALF_WIDTH;
    int const position = builder.add<float>("VEC3", {-w, d, -w, w, d, -w, w, d, w, -w, d, w});
    int const normal = builder.add<float>("VEC3", {0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0});
    int const tangent = builder.add<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    int const uv = builder.add<float>("VEC2", {0, 0, 1, 0, 1, 1, 0, 1});
    int const indices = builder.add<std::uint16_t>("SCALAR", {0, 1, 2, 0, 2, 3});
    builder.show({{"POSITION", position}, {"NORMAL", normal}, {"TANGENT", tangent}, {"TEXCOORD_0", uv}},
                 {{"indices", indices}, {"material", 0}});
    builder.json["images"] = {{{"uri", "data:image/png;base64," + base64(deep_png(map))}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    return builder.load();
}

class DeepPictures : public RenderTest {};

} // namespace

TEST_F(DeepPictures, a_normal_map_of_16_bits_has_no_steps_of_8) {
    Stand const stand = stand_on(airless_planet(), 1000);
    put(leaning_wall(), stand);
    Settings settings = plain_settings();
    settings.shadows = false;
        settings.shafts = "off";
    constexpr double fov = 1;
    renderer().draw(stand.view(stand.camera({0, 0, 0}, {0, 1, 0}, fov, {0, 0, 1}), {0, 1, 0}), settings, SMALL);
    auto const texels = values_of<std::int16_t>(renderer().image_bytes("normal"));
    glm::dvec3 const east = stand.world_direction({1, 0, 0});
    double const half_width = DISTANCE * std::tan(fov / 2) * SMALL.width / SMALL.height; // [m] of what is seen
    for (std::uint32_t x = 0; x < SMALL.width; ++x) {
        std::size_t const at = 4 * (SMALL.height / 2 * SMALL.width + x);
        glm::vec2 const stored(texels[at] / 32767.0f, texels[at + 1] / 32767.0f);
        double const read = glm::dot(glm::dvec3(shader::unit_from_octahedral(stored)), east);
        double const u = 0.5 + ((x + 0.5) / SMALL.width * 2 - 1) * half_width / (2 * HALF_WIDTH);
        double const lean = 2 * (FIRST + STEP * (256 * u - 0.5)) / 65535 - 1;
        // Half a step of the G-buffer is 1.5e-5, the sampler's fractions of a texel make as much. A pixel is 7e-4 on
        // from the last, a step of 8 bits would be 8e-3.
        EXPECT_NEAR(read, lean / std::sqrt(1 + lean * lean), 6e-5) << "column " << x;
    }
}
