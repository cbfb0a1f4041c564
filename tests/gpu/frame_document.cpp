#include "render/frame_document.h"

#include "support/documents.h"
#include "support/render_test.h"

using namespace alpenglow;

class FrameDocument : public test::RenderTest {};

TEST_F(FrameDocument, is_what_the_program_prints) {
    test::Stand const stand = test::stand_on(make_earth());
    Scene scene = test::scene_of({test::matte({0.5f, 0.5f, 0.5f})});
    test::add_plane(scene, 100);
    Renderer newcomer(device()); // its first frame makes the tables
    newcomer.set_scene(&scene, stand.placement, stand.planet.radius);
    World const world = stand.view(stand.camera({0, 50, 100}, {0, 0, 0}, 1), test::sun_at(30, 90));
    std::string text;
    newcomer.draw(world, Settings{}, {64, 36}, [&](FrameGraph& graph, ImageId) { text = frame_document(graph); }, {});
    newcomer.wait();
    test::expect_document("frame.md", text);
}
