#include "support/mesh_places.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;

/// The vertex shader's text in float, against doubles; the same on the device is in tests/gpu/mesh_transform.cpp.
TEST(MeshTransform, vertices_keep_their_place_to_a_fiftieth_of_a_pixel) {
    for (MeshPlace const& place : mesh_places()) {
        double worst = 0;
        for (int step = 0; step < CAMERA_STEPS; ++step) {
            MeshShot const shot = place.shot(step);
            for (glm::vec3 const& vertex : place.vertices) {
                glm::vec4 const clip = shot.clip_from_relative * glm::vec4(shader::relative_from_mesh(shot.draw, vertex), 1);
                worst = std::max(worst, glm::length(pixels_of(clip) - shot.true_pixels(place, vertex)));
            }
        }
        EXPECT_LT(worst, MOST_PIXELS_OFF) << place.name;
    }
}

TEST(MeshTransform, one_float_for_the_camera_would_not_do) {
    // Proves that the test above can fail: without the low part of the camera a vertex 1 m away swims.
    double worst = 0;
    for (MeshPlace const& place : mesh_places()) {
        for (int step = 0; step < CAMERA_STEPS; ++step) {
            MeshShot shot = place.shot(step);
            shot.draw.camera_low = glm::vec3(0);
            glm::vec3 const& vertex = place.vertices.front();
            glm::vec4 const clip = shot.clip_from_relative * glm::vec4(shader::relative_from_mesh(shot.draw, vertex), 1);
            worst = std::max(worst, glm::length(pixels_of(clip) - shot.true_pixels(place, vertex)));
        }
    }
    EXPECT_GT(worst, 10 * MOST_PIXELS_OFF);
}
