#include "render/gpu_scene.h"

#include "gpu/transfer.h"

#include <embedded_shaders.h>

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

/// A vertex as the device reads it: 52 bytes.
struct PackedVertex {
    float position[3];
    std::int16_t normal[4];
    std::int16_t tangent[4];
    float uv[4];
    std::uint16_t color[4];
};
static_assert(sizeof(PackedVertex) == 52);

std::int16_t snorm16(float x) { return static_cast<std::int16_t>(std::lround(std::clamp(x, -1.0f, 1.0f) * 32767.0f)); }
std::uint16_t unorm16(float x) { return static_cast<std::uint16_t>(std::lround(std::clamp(x, 0.0f, 1.0f) * 65535.0f)); }

PackedVertex packed(Vertex const& v) {
    PackedVertex p{};
    for (int i = 0; i < 3; ++i) p.position[i] = v.position[i], p.normal[i] = snorm16(v.normal[i]);
    for (int i = 0; i < 4; ++i) p.tangent[i] = snorm16(v.tangent[i]), p.color[i] = unorm16(v.color[i]);
    p.uv[0] = v.uv0.x, p.uv[1] = v.uv0.y, p.uv[2] = v.uv1.x, p.uv[3] = v.uv1.y;
    return p;
}

glm::dvec3 transformed(glm::dmat4 const& m, glm::dvec3 const& p) { return glm::dvec3(m * glm::dvec4(p, 1.0)); }

Sphere sphere_of(Box const& box, glm::dmat4 const& world_from_mesh) {
    Sphere sphere{transformed(world_from_mesh, box.centre()), 0};
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 const p(corner & 1 ? box.highest.x : box.lowest.x, corner & 2 ? box.highest.y : box.lowest.y,
                           corner & 4 ? box.highest.z : box.lowest.z);
        sphere.radius = std::max(sphere.radius, glm::distance(transformed(world_from_mesh, p), sphere.centre));
    }
    return sphere;
}

/// The two floats whose sum is x. The first goes through memory: GCC 12 at -O3 takes a vectorized way to float and back
/// for nothing, and the second would be 0.
void split(double x, float& high, float& low) {
    float const volatile rounded = static_cast<float>(x);
    high = rounded;
    low = static_cast<float>(x - high);
}

} // namespace

shader::MeshDraw make_mesh_draw(glm::dmat4 const& world_from_mesh, glm::dmat4 const& mesh_from_world,
                                glm::dvec3 const& camera, int projection) {
    glm::dvec3 const in_mesh = transformed(mesh_from_world, camera);
    shader::MeshDraw draw{};
    draw.world_from_mesh = glm::mat3(world_from_mesh);
    for (int i = 0; i < 3; ++i) split(in_mesh[i], draw.camera_high[i], draw.camera_low[i]);
    draw.projection = projection;
    return draw;
}

GpuScene::GpuScene(Device const& device, Scene const& scene, Placement const& placement, double planet_radius)
    : device_(device), world_from_scene_(alpenglow::world_from_scene(placement, planet_radius)),
      planet_radius_(planet_radius), bounds_(scene.bounds), ground_(ground_patches(scene, world_from_scene_, planet_radius)) {
    Staging staging(device);
    materials_ = std::make_unique<MaterialSets>(staging, scene);
    upload_meshes(staging, scene);
    add_items(scene);
}

GpuScene::~GpuScene() = default;

VertexLayout GpuScene::vertex_layout() {
    return {sizeof(PackedVertex),
            {{VERTEX_POSITION, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(PackedVertex, position)},
             {VERTEX_NORMAL, 0, VK_FORMAT_R16G16B16A16_SNORM, offsetof(PackedVertex, normal)},
             {VERTEX_TANGENT, 0, VK_FORMAT_R16G16B16A16_SNORM, offsetof(PackedVertex, tangent)},
             {VERTEX_UV, 0, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(PackedVertex, uv)},
             {VERTEX_COLOR, 0, VK_FORMAT_R16G16B16A16_UNORM, offsetof(PackedVertex, color)}}};
}

void GpuScene::upload_meshes(Staging& staging, Scene const& scene) {
    std::size_t vertex_count = 0, index_count = 0;
    for (Mesh const& mesh : scene.meshes) vertex_count += mesh.vertices.size(), index_count += mesh.indices.size();
    std::vector<PackedVertex> vertices;
    std::vector<std::uint32_t> indices;
    vertices.reserve(vertex_count);
    indices.reserve(index_count);
    for (Mesh const& mesh : scene.meshes) {
        vertex_offsets_.push_back(static_cast<std::int32_t>(vertices.size()));
        index_offsets_.push_back(static_cast<std::uint32_t>(indices.size()));
        for (Vertex const& vertex : mesh.vertices) vertices.push_back(packed(vertex));
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    auto const make = [&](auto const& data, VkBufferUsageFlags usage, char const* name) {
        std::span const bytes = std::as_bytes(std::span(data));
        auto buffer = std::make_unique<GpuBuffer>(device_, std::max<std::size_t>(bytes.size(), 4),
                                                  usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferHome::device, name);
        if (!bytes.empty()) upload(staging, *buffer, bytes);
        return buffer;
    };
    vertices_ = make(vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "vertices");
    indices_ = make(indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "indices");
}

void GpuScene::add_items(Scene const& scene) {
    for (Instance const& instance : scene.instances) {
        auto const index = static_cast<std::uint32_t>(instances_.size());
        glm::dmat4 const world_from_mesh = world_from_scene_ * instance.scene_from_mesh;
        instances_.push_back(
            {world_from_mesh, glm::inverse(world_from_mesh), glm::determinant(glm::dmat3(world_from_mesh)) < 0});
        for (MeshPart const& part : scene.meshes[instance.mesh].parts) {
            DrawItem item{index_offsets_[instance.mesh] + part.first_index,
                          part.index_count,
                          vertex_offsets_[instance.mesh],
                          part.material,
                          index,
                          sphere_of(part.bounds, world_from_mesh)};
            has_masked_ = has_masked_ || (*materials_)[part.material].masked;
            triangles_ += part.index_count / 3;
            items_.push_back(item);
        }
        for (Vertex const& vertex : scene.meshes[instance.mesh].vertices) {
            highest_altitude_ = std::max(highest_altitude_,
                                         glm::length(transformed(world_from_mesh, vertex.position)) - planet_radius_);
        }
    }
}

void GpuScene::draw(DrawContext& context, std::span<std::uint32_t const> items, glm::dvec3 const& camera,
                    int projection, Which which, bool cull) const {
    VkCommandBuffer const commands = context.commands();
    VkDeviceSize const start = 0;
    VkBuffer const vertices = vertices_->handle();
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &start);
    vkCmdBindIndexBuffer(commands, indices_->handle(), 0, VK_INDEX_TYPE_UINT32);
    std::uint32_t material = ~0u, instance = ~0u;
    for (std::uint32_t index : items) {
        DrawItem const& item = items_[index];
        MaterialSets::Entry const& entry = (*materials_)[item.material];
        if (which != Which::all && entry.masked != (which == Which::masked)) continue;
        if (item.material != material) {
            material = item.material;
            context.bind_set1(entry.set);
            vkCmdSetCullMode(commands, cull && !entry.double_sided ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE);
        }
        if (item.instance != instance) {
            instance = item.instance;
            InstanceData const& data = instances_[instance];
            vkCmdSetFrontFace(commands, data.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
            context.push(bytes_of(make_mesh_draw(data.world_from_mesh, data.mesh_from_world, camera, projection)));
        }
        vkCmdDrawIndexed(commands, item.index_count, 1, item.first_index, item.vertex_offset, 0);
    }
}

RasterState GpuScene::surface_pipeline() const {
    return {.vertex = shaders::mesh_vert,
            .fragment = shaders::gbuffer_frag,
            .vertices = vertex_layout(),
            .set1 = material_layout()};
}

std::vector<RasterState> GpuScene::depth_pipelines(float slope_bias) const {
    RasterState const opaque{.vertex = shaders::mesh_vert,
                             .vertices = vertex_layout(),
                             .shadow = true,
                             .slope_bias = slope_bias,
                             .set1 = material_layout()};
    if (!has_masked_) return {opaque};
    RasterState masked = opaque;
    masked.fragment = shaders::shadow_mask_frag;
    return {opaque, masked};
}

void GpuScene::draw_depth(DrawContext& context, std::span<std::uint32_t const> items, glm::dvec3 const& camera,
                          int projection) const {
    context.use(0);
    draw(context, items, camera, projection, Which::opaque, false);
    if (!has_masked_) return;
    context.use(1);
    draw(context, items, camera, projection, Which::masked, false);
}

} // namespace alpenglow
