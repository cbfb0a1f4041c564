#include "reference/terrain_mesh.h"

#include "core/error.h"
#include "reference/surface_material.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace alpenglow {

namespace {

/// A mesh where an instance puts it.
struct PlacedMesh {
    Mesh const* mesh;
    glm::dmat4 local_from_mesh;
    bool mirrored;
    std::vector<glm::vec4> positions; ///< local; Embree reads 16 bytes of each
};

/// An Embree geometry.
struct PlacedPart {
    Scene const* scene;
    PlacedMesh const* placed;
    MeshPart const* part;

    Material const& material() const { return scene->materials[part->material]; }
    TrianglePlace place(std::uint32_t triangle, double u, double v) const;
};

TrianglePlace PlacedPart::place(std::uint32_t triangle, double u, double v) const {
    TrianglePlace place{{}, {1 - u - v, u, v}};
    std::uint32_t const* const index = &placed->mesh->indices[part->first_index + std::size_t{3} * triangle];
    for (std::size_t i = 0; i < 3; ++i) place.corners[i] = &placed->mesh->vertices[index[i]];
    return place;
}

PlacedPart const& part_of(void* user) { return *static_cast<PlacedPart const*>(user); }

void let_cut_out_through(RTCFilterFunctionNArguments const* hit) {
    PlacedPart const& part = part_of(hit->geometryUserPtr);
    TrianglePlace const place =
        part.place(RTCHitN_primID(hit->hit, hit->N, 0), RTCHitN_u(hit->hit, hit->N, 0), RTCHitN_v(hit->hit, hit->N, 0));
    if (cut_out(*part.scene, part.material(), place)) hit->valid[0] = 0;
}

void let_backs_through(RTCFilterFunctionNArguments const* hit) {
    PlacedPart const& part = part_of(hit->geometryUserPtr);
    if (part.material().double_sided) return;
    float const along = RTCHitN_Ng_x(hit->hit, hit->N, 0) * RTCRayN_dir_x(hit->ray, hit->N, 0) +
                        RTCHitN_Ng_y(hit->hit, hit->N, 0) * RTCRayN_dir_y(hit->ray, hit->N, 0) +
                        RTCHitN_Ng_z(hit->hit, hit->N, 0) * RTCRayN_dir_z(hit->ray, hit->N, 0);
    if ((along > 0) != part.placed->mirrored) hit->valid[0] = 0;
}

double largest(glm::dvec3 const& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

void fail_on_error(RTCDevice device) {
    RTCError const error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    throw Error(ErrorKind::bad_input,
                error == RTC_ERROR_OUT_OF_MEMORY
                    ? "the scene's triangles don't fit into the memory of this machine"
                    : fmt::format("Embree can't take the scene's triangles (error {})", int(error)));
}

} // namespace

struct TerrainMesh::State {
    Scene const& scene;
    glm::dmat3 axes;        ///< world from local, a rotation
    glm::dvec3 middle{0};   ///< of the local frame, world [m]
    Box box;                ///< local [m], with room for the rounding
    bool has_backs = false; ///< a single-sided material
    std::vector<PlacedMesh> meshes;
    std::vector<PlacedPart> parts; ///< by Embree's geometry number
    std::unique_ptr<RTCDeviceTy, Release> device;
    std::unique_ptr<RTCSceneTy, Release> tree;

    State(Scene const& scene, Placement const& placement, double planet_radius);
    void place_meshes(glm::dmat4 const& local_from_scene);
    void build_tree();
    void add_geometry(PlacedPart& part);

    /// A ray inside the box, and how far from the true start its own lies.
    struct Clipped {
        RTCRay ray;
        double skipped;
    };
    std::optional<Clipped> clip(glm::dvec3 const& origin, glm::dvec3 const& direction, double longest) const;
    GroundPoint point_at(RTCHit const& hit, glm::dvec3 const& origin, glm::dvec3 const& direction) const;
};

TerrainMesh::State::State(Scene const& scene_, Placement const& placement, double planet_radius) : scene(scene_) {
    glm::dmat4 const world = world_from_scene(placement, planet_radius);
    axes = glm::dmat3(world) * (1 / placement.scale);
    Box const bounds = scene_bounds(scene);
    glm::dvec3 const centre = bounds.empty() ? glm::dvec3(0) : bounds.centre();
    middle = glm::dvec3(world * glm::dvec4(centre, 1));
    glm::dmat4 local_from_scene(placement.scale);
    local_from_scene[3] = glm::dvec4(-placement.scale * centre, 1);
    place_meshes(local_from_scene);
    build_tree();
}

void TerrainMesh::State::place_meshes(glm::dmat4 const& local_from_scene) {
    meshes.reserve(scene.instances.size()); // parts keep pointers
    for (Instance const& instance : scene.instances) {
        Mesh const& mesh = scene.meshes[instance.mesh];
        glm::dmat4 const local_from_mesh = local_from_scene * instance.scene_from_mesh;
        PlacedMesh& placed = meshes.emplace_back(
            PlacedMesh{&mesh, local_from_mesh, glm::determinant(glm::dmat3(local_from_mesh)) < 0, {}});
        placed.positions.reserve(mesh.vertices.size());
        for (Vertex const& vertex : mesh.vertices) {
            glm::dvec4 const local = local_from_mesh * glm::dvec4(vertex.position, 1);
            placed.positions.emplace_back(local);
            box.include(glm::dvec3(local));
        }
        for (MeshPart const& part : mesh.parts) {
            if (part.index_count >= 3) parts.push_back({&scene, &placed, &part});
        }
    }
    glm::dvec3 const size = box.highest - box.lowest;
    double const room = box.empty() ? 0 : position_error(0.5 * largest(size), largest(size));
    box.lowest -= room, box.highest += room;
}

void TerrainMesh::State::build_tree() {
    device.reset(rtcNewDevice("threads=1"));
    fail_on_error(device.get());
    tree.reset(rtcNewScene(device.get()));
    rtcSetSceneFlags(tree.get(),
                     static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    for (PlacedPart& part : parts) add_geometry(part);
    rtcCommitScene(tree.get());
    fail_on_error(device.get());
}

void TerrainMesh::State::add_geometry(PlacedPart& part) {
    PlacedMesh const& placed = *part.placed;
    RTCGeometry const geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, placed.positions.data(), 0,
                               sizeof(glm::vec4), placed.positions.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, placed.mesh->indices.data(),
                               part.part->first_index * sizeof(std::uint32_t), 3 * sizeof(std::uint32_t),
                               part.part->index_count / 3);
    rtcSetGeometryUserData(geometry, &part);
    if (part.material().alpha_mask) {
        rtcSetGeometryIntersectFilterFunction(geometry, let_cut_out_through);
        rtcSetGeometryOccludedFilterFunction(geometry, let_cut_out_through);
    }
    has_backs = has_backs || !part.material().double_sided;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(tree.get(), geometry);
    rtcReleaseGeometry(geometry);
}

std::optional<TerrainMesh::State::Clipped> TerrainMesh::State::clip(glm::dvec3 const& origin,
                                                                    glm::dvec3 const& direction, double longest) const {
    glm::dvec3 const start = (origin - middle) * axes, along = direction * axes; // the transpose's products
    double enter = 0, leave = longest;
    for (int i = 0; i < 3; ++i) {
        double const inverse = 1 / along[i];
        double const a = (box.lowest[i] - start[i]) * inverse, b = (box.highest[i] - start[i]) * inverse;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave)) return {};
    glm::vec3 const from(start + enter * along), to(along);
    Clipped clipped{{}, enter};
    clipped.ray.org_x = from.x, clipped.ray.org_y = from.y, clipped.ray.org_z = from.z;
    clipped.ray.dir_x = to.x, clipped.ray.dir_y = to.y, clipped.ray.dir_z = to.z;
    clipped.ray.tfar = static_cast<float>(leave - enter);
    clipped.ray.mask = ~0u;
    return clipped;
}

GroundPoint TerrainMesh::State::point_at(RTCHit const& hit, glm::dvec3 const& origin,
                                         glm::dvec3 const& direction) const {
    PlacedPart const& part = parts[hit.geomID];
    TrianglePlace const place = part.place(hit.primID, hit.u, hit.v);
    glm::dmat4 const& local_from_mesh = part.placed->local_from_mesh;
    std::array<glm::dvec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = glm::dvec3(local_from_mesh * glm::dvec4(place.corners[i]->position, 1));
    }
    glm::dvec3 const ab = corners[1] - corners[0], ac = corners[2] - corners[0], across = axes * glm::cross(ab, ac);
    double const reach = std::max({largest(corners[0]), largest(corners[1]), largest(corners[2])});
    double const off = position_error(reach, std::max({largest(ab), largest(ac), largest(ac - ab)}));

    GroundPoint point;
    point.facing = across == glm::dvec3(0) ? -direction : glm::normalize(across);
    if (glm::dot(point.facing, direction) > 0) point.facing = -point.facing;
    glm::dvec3 const on_triangle = middle + axes * (corners[0] + place.weights.y * ab + place.weights.z * ac);
    point.distance = std::max(glm::dot(on_triangle - origin, direction), 0.0);
    point.position = on_triangle + off * point.facing;
    point.shading = shading_normal(scene, part.material(), place, axes * glm::dmat3(local_from_mesh), point.facing);
    point.surface = surface_at(scene, part.material(), place);
    point.emission = emission_at(scene, part.material(), place);
    return point;
}

TerrainMesh::TerrainMesh(Scene const& scene, Placement const& placement, double planet_radius)
    : state_(std::make_unique<State>(scene, placement, planet_radius)) {}

TerrainMesh::~TerrainMesh() = default;

bool TerrainMesh::empty() const { return state_->parts.empty(); }

double TerrainMesh::position_error(double reach, double extent) {
    // A coordinate is rounded by 2^-24 of its size, on three axes, for the corner and for the ray's start: 2 sqrt(3),
    // below 4. The intersection rounds differences of them, each as long as the triangle at most where the ray starts
    // on it.
    constexpr double ROUNDING = 0x1p-24;
    return 4 * ROUNDING * reach + 8 * ROUNDING * extent;
}

std::optional<GroundPoint> TerrainMesh::first_hit(glm::dvec3 const& origin, glm::dvec3 const& direction, double longest,
                                                  Sides sides) const {
    auto const clipped = state_->clip(origin, direction, longest);
    if (!clipped) return {};
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (sides == Sides::seen && state_->has_backs) context.filter = let_backs_through;
    RTCRayHit query{clipped->ray, {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->tree.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    GroundPoint point = state_->point_at(query.hit, origin, direction);
    if (point.distance >= longest) return {};
    return point;
}

bool TerrainMesh::occludes(glm::dvec3 const& origin, glm::dvec3 const& direction) const {
    auto clipped = state_->clip(origin, direction, std::numeric_limits<double>::infinity());
    if (!clipped) return false;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(state_->tree.get(), &context, &clipped->ray);
    return clipped->ray.tfar < 0;
}

} // namespace alpenglow
