#pragma once

#include "frame/mesh_transform.glsl"
#include "render/frame_constants.h"
#include "render/gpu_scene.h"
#include "scene/view.h"

#include <string>
#include <vector>

/// Vertices where floats are short: far from their mesh's origin, and near the camera, all over the planet.
namespace alpenglow::test {

constexpr Extent FULL_HD{1920, 1080};
constexpr double MOST_PIXELS_OFF = 0.02;
constexpr int CAMERA_STEPS = 40;      // of
constexpr double CAMERA_STEP = 1e-4;  // [m]

inline glm::dvec2 pixels_of(glm::dvec4 const& clip) { return 0.5 * glm::dvec2(clip) / clip.w * glm::dvec2(FULL_HD.width, FULL_HD.height); }

struct MeshPlace;

/// One frame: what the vertex shader gets, and what it should find.
struct MeshShot {
    Camera camera;
    shader::MeshDraw draw;
    glm::mat4 clip_from_relative;

    glm::dvec2 true_pixels(MeshPlace const& place, glm::vec3 const& vertex) const;
};

struct MeshPlace {
    std::string name;
    glm::dmat4 world_from_mesh{1};
    Camera camera;
    glm::dvec3 step{0};               ///< of the camera [m]
    std::vector<glm::vec3> vertices;

    MeshShot shot(int index) const {
        MeshShot shot{camera, {}, {}};
        shot.camera.position += static_cast<double>(index) * step;
        World const world{make_earth(), shot.camera, {0, 0, 1}};
        shot.clip_from_relative = make_frame_constants(world, {}, FULL_HD, {}, {}, {}, 0).clip_from_relative[PROJECTION_VIEW];
        shot.draw = make_mesh_draw(world_from_mesh, glm::inverse(world_from_mesh), shot.camera.position, PROJECTION_VIEW);
        return shot;
    }
};

inline glm::dvec2 MeshShot::true_pixels(MeshPlace const& place, glm::vec3 const& vertex) const {
    glm::dvec3 const world(place.world_from_mesh * glm::dvec4(vertex, 1));
    glm::dvec3 const seen = glm::transpose(camera.world_from_camera) * (world - camera.position);
    double const scale = 1 / std::tan(0.5 * camera.vertical_fov), aspect = double(FULL_HD.width) / FULL_HD.height;
    return pixels_of({scale / aspect * seen.x, -scale * seen.y, 0, -seen.z});
}

/// A mesh anchored at a place of the globe, and a camera 1 m from that of its vertices which is `away` metres from its origin.
inline MeshPlace mesh_place(std::string name, double latitude, double longitude, double away) {
    Placement placement;
    placement.anchor = {glm::radians(latitude), glm::radians(longitude), 800};
    placement.yaw = 0.7;
    double const radius = make_earth().radius;
    MeshPlace place{std::move(name), world_from_scene(placement, radius), {}, {}, {}};
    glm::vec3 const near(glm::normalize(glm::dvec3(0.8, 0.02, -0.6)) * away);
    glm::dmat3 const axes(place.world_from_mesh);
    glm::dvec3 const back = axes * glm::normalize(glm::dvec3(-0.3, 0.1, 0.9)), right = glm::normalize(glm::cross(axes[1], back));
    place.camera.world_from_camera = {right, glm::cross(back, right), back};
    place.camera.position = glm::dvec3(place.world_from_mesh * glm::dvec4(near, 1)) + back; // 1 m
    place.camera.vertical_fov = glm::radians(60.0);
    place.step = CAMERA_STEP * glm::normalize(right + 0.5 * back + 0.3 * glm::cross(back, right));
    // That vertex, and others in view: beside it, and 1, 5 and 30 km farther on.
    place.vertices = {near, near + glm::vec3(0.1f, 0.1f, 0.05f)};
    glm::dvec3 const ahead = -glm::normalize(glm::dvec3(-0.3, 0.1, 0.9));
    for (double const farther : {1e3, 5e3, 3e4}) place.vertices.push_back(near + glm::vec3(farther * (ahead + glm::dvec3(0.1, 0.2, 0.05))));
    return place;
}

inline std::vector<MeshPlace> mesh_places() {
    std::vector<MeshPlace> places;
    for (double const away : {0.0, 1e3, 5e3, 3e4}) {
        std::string const distance = std::to_string(static_cast<int>(away)) + " m from the origin, ";
        places.push_back(mesh_place(distance + "equator", 0, 20, away));
        places.push_back(mesh_place(distance + "north pole", 90, 0, away));
        places.push_back(mesh_place(distance + "date line", -17, 180, away));
    }
    return places;
}

} // namespace alpenglow::test
