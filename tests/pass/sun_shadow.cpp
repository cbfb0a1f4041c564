#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{192, 108};
constexpr double HEIGHT = 60; // of the camera above the plane [m]
glm::dvec3 const BOX_CENTRE{0, 2, 0}, BOX_HALF{2, 2, 2};

/// A box on a plane without air, so that shadow is black; seen from straight above, up in the picture is north.
class ShadowPass : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        Scene scene = scene_of({matte(glm::vec3(0.5))});
        add_plane(scene, 20);
        add_box(scene, BOX_CENTRE, BOX_HALF);
        put(scene, stand_);
        settings_ = plain_settings();
    }
    /// `width` [m] of the plane fill the picture.
    Camera above(double east, double z, double width, double turn = 0) const {
        double const fov = 2 * std::atan(0.5 * width / HEIGHT * EXTENT.height / EXTENT.width);
        return stand_.camera({east, HEIGHT, z}, {east, 0, z}, fov, {std::sin(turn), 0, -std::cos(turn)});
    }
    std::vector<double> visibility(Camera const& camera, glm::dvec3 const& to_sun) {
        return RenderTest::visibility(stand_.view(camera, to_sun), settings_, EXTENT);
    }
    /// Where a pixel's ray meets the plane, in the scene's frame.
    glm::dvec3 on_plane(Camera const& camera, double x, double y) const {
        glm::dmat4 const scene_from_world = glm::inverse(stand_.world_from_scene());
        glm::dvec3 const eye(scene_from_world * glm::dvec4(camera.position, 1));
        glm::dvec3 const along = glm::dmat3(scene_from_world) * pixel_direction(camera, EXTENT, x, y);
        return eye - along * (eye.y / along.y);
    }
    double texel(Camera const& camera, glm::dvec3 const& to_sun) const {
        ShadowSettings const wanted{settings_.cascades, settings_.cascade_size, settings_.shadow_reach};
        ShadowScene const scene{{{-20, 0, -20}, {20, 4, 20}}, stand_.world_from_scene()};
        // The view lies within the coarsest cascade; a finer one may serve parts of it.
        return fit_cascades(scene, camera, glm::normalize(stand_.world_direction(to_sun)), wanted).cascades.back().texel;
    }

    Stand stand_ = stand_on(airless_planet(), 500);
    Settings settings_;
};

/// Whether the box hides the sun.
bool in_shadow(glm::dvec3 const& place, glm::dvec3 const& to_sun) {
    glm::dvec3 const a = (BOX_CENTRE - BOX_HALF - place) / to_sun, b = (BOX_CENTRE + BOX_HALF - place) / to_sun;
    glm::dvec3 const in = glm::min(a, b), out = glm::max(a, b);
    return std::max({in.x, in.y, in.z}) < std::min({out.x, out.y, out.z}) && std::min({out.x, out.y, out.z}) > 0;
}

/// Whether all places within `radius` [m], measured across the sun's rays, are alike.
bool alike_around(glm::dvec3 const& place, glm::dvec3 const& to_sun, double radius) {
    glm::dvec3 const x = glm::normalize(glm::cross(to_sun, glm::dvec3(0.1, 0.2, 0.97))), y = glm::cross(to_sun, x);
    bool const middle = in_shadow(place, to_sun);
    for (int i = 0; i < 24; ++i) {
        double const angle = i * 2 * 3.14159265 / 24;
        if (in_shadow(place + radius * (std::cos(angle) * x + std::sin(angle) * y), to_sun) != middle) return false;
    }
    return true;
}

bool on_box(glm::dvec3 const& place) { return std::max(std::abs(place.x), std::abs(place.z)) < 2.3; } // its top is nearer to the camera

struct Sun {
    double elevation, azimuth; // [degrees]
};
constexpr Sun SUNS[] = {{2, 20}, {5, 0}, {10, 35}, {30, 0}, {30, 80}, {60, 35}, {80, 10}};

} // namespace

/// One comparison covers the edge's place, acne (lit ground with a pixel that is not) and a gap at the foot (ground behind
/// the box that is lit).
TEST_F(ShadowPass, a_boxs_shadow_is_where_geometry_puts_it) {
    for (int const cascades : {1, 4}) {
        settings_.cascades = cascades;
        for (Sun const& sun : SUNS) {
            glm::dvec3 const to_sun = sun_at(sun.elevation, sun.azimuth);
            // The shadow falls away from the sun: look at where it is.
            Camera const camera = above(-2 * to_sun.x / std::abs(to_sun.y + 0.3), -2 * to_sun.z / std::abs(to_sun.y + 0.3), 16);
            double const width = texel(camera, to_sun);
            std::vector<double> const seen = visibility(camera, to_sun);
            int wrong_side = 0, unclean = 0, checked = 0;
            for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
                glm::dvec3 const place = on_plane(camera, i % EXTENT.width, i / EXTENT.width);
                if (on_box(place) || std::max(std::abs(place.x), std::abs(place.z)) > 19) continue;
                double const expected = in_shadow(place, to_sun) ? 0 : 1;
                // The edge, where half of the sun is seen, lies within two texels; behind five the soft filter has ended.
                if (alike_around(place, to_sun, 2 * width)) ++checked, wrong_side += std::abs(seen[i] - expected) > 0.5;
                if (alike_around(place, to_sun, 5 * width)) unclean += std::abs(seen[i] - expected) > 0.01;
            }
            EXPECT_GT(checked, 5000) << sun.elevation;
            EXPECT_EQ(wrong_side, 0) << "elevation " << sun.elevation << ", azimuth " << sun.azimuth << ", cascades " << cascades;
            EXPECT_EQ(unclean, 0) << "elevation " << sun.elevation << ", azimuth " << sun.azimuth << ", cascades " << cascades;
        }
    }
}

namespace {

/// Where, in each row, the sun comes out from one pixel to the next: places along the shadow's eastern edge, in the scene's frame.
std::vector<glm::dvec3> eastern_edge(std::vector<double> const& visibility, auto const& place_of) {
    std::vector<glm::dvec3> edge;
    for (std::uint32_t y = 0; y < EXTENT.height; ++y) {
        for (std::uint32_t x = 0; x + 1 < EXTENT.width; ++x) {
            double const a = visibility[y * EXTENT.width + x], b = visibility[y * EXTENT.width + x + 1];
            if (a < 0.5 && b >= 0.5) edge.push_back(place_of(x + (0.5 - a) / (b - a), y));
        }
    }
    return edge;
}

/// How far east the edge is at the place nearest to `z`.
double east_at(std::vector<glm::dvec3> const& edge, double z) {
    return std::ranges::min_element(edge, {}, [z](glm::dvec3 const& place) { return std::abs(place.z - z); })->x;
}

} // namespace

TEST_F(ShadowPass, the_edge_stays_where_it_is_when_the_camera_moves_and_turns) {
    settings_.cascades = 1;
    settings_.cascade_size = 512;
    glm::dvec3 const to_sun = sun_at(45, 10); // the texels run askew to the edge, which is a stair of theirs
    double const width = texel(above(1, 4, 5), to_sun);
    std::vector<glm::dvec3> still;
    for (int step = 0; step < 6; ++step) {
        Camera const camera = above(1 + step * width / 3, 4, 5, glm::radians(static_cast<double>(step % 2)));
        auto const edge = eastern_edge(visibility(camera, to_sun), [&](double x, double y) { return on_plane(camera, x, y); });
        ASSERT_GT(edge.size(), EXTENT.height / 2);
        if (step == 0) still = edge;
        double furthest = 0;
        for (glm::dvec3 const& place : edge) {
            if (place.z > still.front().z && place.z < still.back().z) furthest = std::max(furthest, std::abs(place.x - east_at(still, place.z)));
        }
        // A pixel is a sixth of a texel. Were the grid to move with the camera, so would the stairs, by a third of a texel.
        EXPECT_LT(furthest, 0.1 * width) << "step " << step;
    }
}

TEST_F(ShadowPass, casters_out_of_the_picture_are_kept) {
    // Looking at the shadow alone, with all of the box four metres behind the camera: the ground there is dark.
    settings_.cascades = 4;
    glm::dvec3 const to_sun = sun_at(30, 0);
    Camera const camera = stand_.camera({0, 0.5, 6}, {0, 0, 8}, glm::radians(20.0));
    std::vector<double> const seen = visibility(camera, to_sun);
    EXPECT_NEAR(seen[EXTENT.pixels() / 2 + EXTENT.width / 2], 0, 0.01);
}
