#include "support/gpu_test.h"
#include "support/mesh_places.h"

#include <test_shaders.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

class MeshTransformOnGpu : public GpuTest {};

struct Push {
    glm::mat4 clip_from_relative;
    shader::MeshDraw draw;
};

} // namespace

TEST_F(MeshTransformOnGpu, vertices_keep_their_place_to_a_fiftieth_of_a_pixel) {
    for (MeshPlace const& place : mesh_places()) {
        double worst = 0;
        for (int step = 0; step < CAMERA_STEPS; step += 8) {
            MeshShot const shot = place.shot(step);
            std::vector<glm::vec4> input(64);
            for (std::size_t i = 0; i < place.vertices.size(); ++i) input[i] = glm::vec4(place.vertices[i], 0);
            auto const clip = run_compute(device(), shaders::mesh_transform_comp, input, {8, 8}, bytes_of(Push{shot.clip_from_relative, shot.draw}));
            for (std::size_t i = 0; i < place.vertices.size(); ++i) {
                worst = std::max(worst, glm::length(pixels_of(clip[i]) - shot.true_pixels(place, place.vertices[i])));
            }
        }
        EXPECT_LT(worst, MOST_PIXELS_OFF) << place.name;
    }
}
