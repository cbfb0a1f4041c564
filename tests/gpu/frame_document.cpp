#include "render/frame_document.h"

#include "render/renderer.h"
#include "support/documents.h"

using namespace alpenglow;

namespace {

/// The smallest scene that has shadows: one triangle.
Scene one_triangle() {
    Mesh mesh;
    mesh.vertices = {{.position = {0, 0, 0}}, {.position = {100, 0, 0}}, {.position = {0, 100, 0}}};
    mesh.indices = {0, 1, 2};
    Box bounds;
    for (Vertex const& vertex : mesh.vertices) bounds.include(vertex.position);
    mesh.parts = {{.first_index = 0, .index_count = 3, .material = 0, .bounds = bounds}};
    Scene scene;
    scene.meshes = {mesh};
    scene.materials = {{}};
    scene.instances = {{}};
    scene.bounds = scene_bounds(scene);
    return scene;
}

} // namespace

TEST(FrameDocument, is_what_the_program_prints) {
    DeviceOptions options;
    options.validation = true;
    Device const device(options);
    Renderer renderer(device);
    Planet const earth = make_earth();
    View view{.scene = "one triangle", .camera = {.place = {default_anchor.latitude, default_anchor.longitude, 200}}};
    Scene const scene = one_triangle();
    renderer.set_scene(&scene, scene_placement(view), earth.radius);
    std::string text;
    renderer.draw(make_world(view, earth), view.settings, {64, 36}, [&](FrameGraph& graph, ImageId) { text = frame_document(graph); }, {});
    renderer.wait();
    EXPECT_TRUE(device.messages().empty());
    test::expect_document("frame.md", text);
}
