#include "encoding/octahedral.glsl"
#include "support/render_test.h"

#include <array>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent SMALL{16, 8};

class GBufferPass : public RenderTest {
protected:
    /// A wall that fills the picture, `distance` [m] straight above the camera, where no planet is behind it.
    void draw_wall(Material const& material, double distance, glm::dvec3 const& normal = {0, -1, 0}, Picture const& picture = one_texel({0, 0, 0, 255})) {
        Scene scene = scene_of({material});
        scene.pictures[0] = picture;
        add_quad(scene, {0, distance, 0}, {3 * distance, 0, 0}, {0, 0, 3 * distance});
        for (Vertex& vertex : scene.meshes[0].vertices) vertex.normal = glm::vec3(normal);
        put(scene, stand_);
        draw();
    }
    void draw() {
        Settings settings = plain_settings();
        settings.shadows = false;
        settings.shafts = "off";
        renderer().draw(stand_.view(stand_.camera({0, 0, 0}, {0, 1, 0}, 1, {0, 0, 1}), {0, 1, 0}), settings, SMALL);
    }
    /// The channels of the middle pixel.
    template <typename T>
    std::vector<T> middle(char const* name) {
        auto const all = values_of<T>(renderer().image_bytes(name));
        std::size_t const channels = all.size() / SMALL.pixels(), at = (SMALL.height / 2 * SMALL.width + SMALL.width / 2) * channels;
        return {all.begin() + static_cast<std::ptrdiff_t>(at), all.begin() + static_cast<std::ptrdiff_t>(at + channels)};
    }

    Stand stand_ = stand_on(airless_planet(), 1000);
};

double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

/// An unsigned float with 5 bits of exponent and `mantissa` bits.
double small_float(std::uint32_t bits, int mantissa) {
    int const exponent = static_cast<int>(bits >> mantissa);
    double const fraction = static_cast<double>(bits & ((1u << mantissa) - 1)) / (1u << mantissa);
    return exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1 + fraction, exponent - 15);
}

} // namespace

TEST_F(GBufferPass, takes_24_bytes_a_pixel) {
    draw();
    std::size_t bytes = 0;
    for (char const* const name : {"albedo", "normal", "material", "emission", "depth"}) bytes += renderer().image_bytes(name).size();
    EXPECT_EQ(bytes, 24 * SMALL.pixels());
}

TEST_F(GBufferPass, a_uniform_planet_is_matte_and_other_surfaces_are_not) {
    draw_wall(matte(glm::vec3(0.5)), 10);
    EXPECT_EQ(middle<std::uint8_t>("material")[2], 255);
    Planet planet = airless_planet();
    planet.look = GroundLook::uniform;
    planet.ground_albedo = {0.5, 0.25, 0};
    Stand const stand = stand_on(planet, 10);
    Scene const nothing = scene_of({});
    put(nothing, stand);
    constexpr double PI = 3.14159265358979;
    // Low, ahead, where a glossy ground would shine.
    FloatImage const seen = radiance(stand.view(stand.camera({0, 0, 0}, {0, -2, -10}, 0.2), sun_at(10, 0)), plain_settings(), SMALL);
    glm::dvec3 const lambert = planet.ground_albedo * std::sin(10 * PI / 180) / PI;
    glm::vec3 const middle_pixel = pixel(seen, SMALL.width / 2, SMALL.height / 2);
    // Half a step of 1/255 in sRGB is 0.9 % of 0.25. A dielectric's gloss would add 0.01 here, to black too.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(middle_pixel[c], lambert[c], 0.01 * lambert[c]) << c;
}

TEST_F(GBufferPass, albedo_is_within_half_a_step_of_srgb) {
    for (double const x : {0.0, 0.001, 0.01, 0.1, 0.3, 0.77, 1.0}) {
        draw_wall(matte(glm::vec3(glm::dvec3(x, 0.5 * x, 1 - x))), 10);
        auto const texel = middle<std::uint8_t>("albedo");
        double const expected[] = {srgb(x), srgb(0.5 * x), srgb(1 - x)};
        // A tenth of a step more, for the driver's own conversion: what Direct3D's specification allows it too.
        for (std::size_t c = 0; c < 3; ++c) EXPECT_LE(std::abs(texel[c] - 255 * expected[c]), 0.6) << x;
    }
}

TEST_F(GBufferPass, occlusion_roughness_and_metalness_are_within_half_a_step) {
    Material material = matte(glm::vec3(0.5));
    material.occlusion_texture.picture = 0;
    material.occlusion_strength = 0.7f;
    material.roughness = 0.333f;
    material.metallic = 0.71f;
    draw_wall(material, 10, {0, -1, 0}, one_texel({100, 0, 0, 255}));
    EXPECT_NEAR(middle<std::uint8_t>("albedo")[3] / 255.0, 1 - 0.7 * (1 - 100 / 255.0), 1 / 510.0 + 1e-5);
    EXPECT_NEAR(middle<std::uint8_t>("material")[0] / 255.0, 0.333, 1 / 510.0 + 1e-5);
    EXPECT_NEAR(middle<std::uint8_t>("material")[1] / 255.0, 0.71, 1 / 510.0 + 1e-5);
}

TEST_F(GBufferPass, reflectance_is_exact_by_default_and_else_within_half_a_step) {
    draw_wall(matte(glm::vec3(0.5)), 10);
    EXPECT_EQ(middle<std::uint8_t>("material")[3], 51) << "51/255 of 0.2 is 0.04";
    Material material = matte(glm::vec3(0.5));
    material.reflectance = 0.113f;
    material.specular = 0.4f;
    draw_wall(material, 10);
    EXPECT_NEAR(middle<std::uint8_t>("material")[3] / 255.0, 0.113 / 0.2, 1 / 510.0 + 1e-5);
    EXPECT_NEAR(middle<std::uint8_t>("material")[2] / 255.0, 0.4, 1 / 510.0 + 1e-5);
}

TEST_F(GBufferPass, textures_lower_specular_weight_and_reflectance) {
    Material material = matte(glm::vec3(0.5));
    material.reflectance = 0.15f, material.specular = 0.8f;
    material.reflectance_shares = {0.5f, 0.25f, 0.25f};
    material.specular_texture.picture = material.reflectance_texture.picture = 0;
    draw_wall(material, 10, {0, -1, 0}, one_texel({188, 255, 0, 102}));
    double const red = std::pow((188 / 255.0 + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(middle<std::uint8_t>("material")[3] / 255.0, 0.15 / 0.2 * (0.5 * red + 0.25), 1 / 510.0 + 1e-4);
    EXPECT_NEAR(middle<std::uint8_t>("material")[2] / 255.0, 0.8 * 0.4, 1 / 510.0 + 1e-5);
    material.specular_texture = {}; // one of the two alone
    material.reflectance = 0.9f;
    draw_wall(material, 10, {0, -1, 0}, one_texel({255, 255, 255, 102}));
    EXPECT_EQ(middle<std::uint8_t>("material")[3], 255) << "no more than the G-buffer holds";
    EXPECT_NEAR(middle<std::uint8_t>("material")[2] / 255.0, 0.8, 1 / 510.0 + 1e-5);
}

TEST_F(GBufferPass, colours_of_16_bits_are_srgb_as_those_of_8_are) {
    Material material = matte(glm::vec3(1));
    material.base_color_texture.picture = 0;
    for (int const byte : {1, 5, 50, 188, 254}) {
        auto const word = static_cast<std::uint16_t>(257 * byte);
        draw_wall(material, 10, {0, -1, 0}, {"deep", 1, 1, {}, {word, word, word, 65535}});
        EXPECT_EQ(middle<std::uint8_t>("albedo")[0], byte);
    }
}

TEST_F(GBufferPass, mipmaps_of_colours_are_means_of_light_and_those_of_data_of_numbers) {
    Material material = matte(glm::vec3(1));
    material.metallic = 1;
    material.base_color_texture.picture = material.metallic_roughness_texture.picture = 0;
    Picture const bytes{"checkers", 2, 1, {255, 255, 255, 255, 0, 0, 0, 255}};
    Picture const words{"checkers", 2, 1, {}, {65535, 65535, 65535, 65535, 0, 0, 0, 65535}};
    for (Picture const& picture : {bytes, words}) {
        Scene scene = scene_of({material});
        scene.pictures[0] = picture;
        add_quad(scene, {0, 10, 0}, {30, 0, 0}, {0, 0, 30});
        // Thousands of texels in a pixel: the picture's last level alone.
        for (Vertex& vertex : scene.meshes[0].vertices) vertex.uv0 = glm::vec2(vertex.position.x, vertex.position.z) * 1e3f;
        put(scene, stand_);
        draw();
        // Half of white's light is 187.5 in sRGB; the device's filter and rounding may take a step.
        EXPECT_NEAR(middle<std::uint8_t>("albedo")[0], 187.5, 1);
        EXPECT_NEAR(middle<std::uint8_t>("material")[1], 127.5, 1) << "metalness";
    }
}

TEST_F(GBufferPass, unlit_surfaces_only_shine) {
    Material material = matte(glm::vec3(0.5f, 1, 0.25f));
    material.unlit = true;
    draw_wall(material, 10);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(middle<std::uint8_t>("albedo")[c], 0);
    EXPECT_EQ(middle<std::uint8_t>("material")[2], 0);
    EXPECT_NEAR(small_float(middle<std::uint32_t>("emission")[0] & 0x7ff, 6) * 3.14159265 / 0.5, 1, 1 / 128.0);
}

TEST_F(GBufferPass, normals_are_within_five_thousandths_of_a_degree) {
    for (glm::dvec3 const& direction : {glm::dvec3(0, -1, 0), {0.3, -0.9, 0.2}, {-0.8, -0.3, 0.1}, {0.5, -0.7, -0.5}, {0.01, -0.01, 0.99}}) {
        draw_wall(matte(glm::vec3(0.5)), 10, glm::normalize(direction));
        auto const texel = middle<std::int16_t>("normal");
        for (std::size_t pair : {0u, 2u}) { // shading and surface normal
            glm::dvec3 const read(shader::unit_from_octahedral(glm::vec2(texel[pair] / 32767.0f, texel[pair + 1] / 32767.0f)));
            glm::dvec3 const expected = stand_.world_direction(glm::normalize(direction));
            EXPECT_LT(glm::degrees(glm::length(glm::cross(read, expected))), 0.005);
            EXPECT_GT(glm::dot(read, expected), 0);
        }
    }
}

TEST_F(GBufferPass, emission_is_within_a_128th) {
    for (float const brightness : {0.002f, 0.37f, 1.0f, 42.0f}) {
        Material material = matte(glm::vec3(0.5));
        material.emission = glm::vec3(1.0f, 0.61f, 0.83f) * brightness;
        draw_wall(material, 10);
        std::uint32_t const texel = middle<std::uint32_t>("emission")[0];
        EXPECT_NEAR(small_float(texel & 0x7ff, 6) / material.emission.r, 1, 1 / 128.0);
        EXPECT_NEAR(small_float(texel >> 11 & 0x7ff, 6) / material.emission.g, 1, 1 / 128.0);
        EXPECT_NEAR(small_float(texel >> 22, 5) / material.emission.b, 1, 1 / 64.0);
    }
}

TEST_F(GBufferPass, depth_is_reversed_and_infinite_and_good_to_a_millionth) {
    float before = 1;
    for (double distance = 0.2; distance < 2e7; distance *= 7) {
        draw_wall(matte(glm::vec3(0.5)), distance);
        float const depth = middle<float>("depth")[0];
        // 6e-8 from the format, the rest from the vertices' floats and their interpolation.
        EXPECT_NEAR(0.1 / depth / distance, 1, 1e-6) << distance; // the near plane lies at 0.1 m
        EXPECT_LT(depth, before);
        EXPECT_GT(depth, 0);
        before = depth;
    }
}

TEST_F(GBufferPass, the_planets_depth_is_its_distance) {
    for (double const altitude : {2.0, 1e3, 1e5, 4e5, 2e7}) {
        stand_ = stand_on(airless_planet(), altitude);
        renderer().draw(stand_.view(stand_.camera({0, 0, 0}, {0, -1, 0}, 0.01, {0, 0, -1}), {0, 1, 0}), plain_settings(), SMALL);
        // Half a pixel of 0.00125 rad off the middle: 1e-6 at most farther from 20 000 km. The camera's altitude is a float.
        EXPECT_NEAR(0.1 / middle<float>("depth")[0] / altitude, 1, 3e-6) << altitude;
    }
}

TEST_F(GBufferPass, the_nearer_of_two_walls_wins_from_1_m_to_10_000_km) {
    constexpr double APART = 1e-5; // of the distance
    for (double distance = 1; distance < 2e7; distance *= 10) {
        for (bool const near_first : {true, false}) {
            Scene scene = scene_of({matte({1, 0, 0}), matte({0, 0, 1})});
            for (int i = 0; i < 2; ++i) {
                bool const near = (i == 0) == near_first;
                double const d = near ? distance : distance * (1 + APART);
                add_quad(scene, {0, d, 0}, {3 * d, 0, 0}, {0, 0, 3 * d}, near ? 0 : 1);
            }
            put(scene, stand_);
            draw();
            auto const albedo = values_of<std::uint8_t>(renderer().image_bytes("albedo"));
            for (std::size_t i = 0; i < SMALL.pixels(); ++i) ASSERT_TRUE(albedo[4 * i] == 255 && albedo[4 * i + 2] == 0) << distance << " m, pixel " << i;
        }
    }
}

TEST_F(GBufferPass, the_sea_and_a_low_plate_do_not_fight) {
    // A plate 5 m above the sea's highest place in view, or below its lowest: a depth of 24 bits would fail at 10 km.
    for (double const eye : {7.0, 100.0, 1e4, 1e5}) {
        double const drop = 0.04 * eye * eye / (2 * stand_.planet.radius); // of the sea at the picture's edge
        for (double const height : {5.0, -5.0 - drop}) {
            Scene scene = scene_of({matte({1, 0, 0})});
            add_plane(scene, 2 * eye, height);
            stand_ = stand_on(airless_planet(), 0);
            put(scene, stand_);
            // Slanted, so that depth varies over the picture; all of it lies on the plate.
            renderer().draw(stand_.view(stand_.camera({0, eye, 0}, {0, 0, -0.1 * eye}, 0.1), {0, 1, 0}), plain_settings(), SMALL);
            auto const albedo = values_of<std::uint8_t>(renderer().image_bytes("albedo"));
            bool const plate_wins = height > 0;
            for (std::size_t i = 0; i < SMALL.pixels(); ++i) ASSERT_EQ(albedo[4 * i] == 255, plate_wins) << "from " << eye << " m, pixel " << i;
        }
    }
}
