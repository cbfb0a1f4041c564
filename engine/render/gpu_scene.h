#pragma once

#include "gpu/buffer.h"
#include "interop/gbuffer.h"
#include "render/frame_graph.h"
#include "render/material_sets.h"
#include "scene/scene_albedo.h"

#include <memory>

namespace alpenglow {

/// A sphere around a part of a mesh, in world space [m].
struct Sphere {
    glm::dvec3 centre{0};
    double radius = 0;
};

/// One draw: a part of a mesh of an instance.
struct DrawItem {
    std::uint32_t first_index = 0, index_count = 0;
    std::int32_t vertex_offset = 0;
    std::uint32_t material = 0, instance = 0;
    Sphere bounds;
};

/// What the vertex shader needs to draw an instance, with the matrix `projection` of interop/frame.h. `camera`: world
/// [m].
shader::MeshDraw make_mesh_draw(glm::dmat4 const& world_from_mesh, glm::dmat4 const& mesh_from_world,
                                glm::dvec3 const& camera, int projection);

/// A scene on the device, standing on a planet: one vertex and one index buffer, a descriptor set for each material.
class GpuScene {
public:
    GpuScene(Device const& device, Scene const& scene, Placement const& placement, double planet_radius);
    ~GpuScene();
    GpuScene(GpuScene const&) = delete;
    GpuScene& operator=(GpuScene const&) = delete;

    std::vector<DrawItem> const& items() const { return items_; }
    std::size_t triangles() const { return triangles_; }
    Box const& bounds() const { return bounds_; } ///< scene frame
    glm::dmat4 const& world_from_scene() const { return world_from_scene_; }
    std::vector<GroundPatch> const& ground() const { return ground_; }
    double highest_altitude() const { return highest_altitude_; } ///< [m] above the planet's radius

    /// Draws those of the items whose material fits into the current pass, with the matrix `projection` of
    /// interop/frame.h.
    enum class Which { all, opaque, masked };
    void draw(DrawContext& context, std::span<std::uint32_t const> items, glm::dvec3 const& camera, int projection,
              Which which, bool cull) const;
    /// Of passes that draw surfaces into a G-buffer.
    RasterState surface_pipeline() const;
    /// Draws the items' depth alone, in a pass with the `depth_pipelines`: the opaque ones, then those with holes.
    void draw_depth(DrawContext& context, std::span<std::uint32_t const> items, glm::dvec3 const& camera,
                    int projection) const;
    /// `slope_bias` [texels of depth for each unit of slope].
    std::vector<RasterState> depth_pipelines(float slope_bias) const;
    bool has_masked() const { return has_masked_; }
    VkDescriptorSetLayout material_layout() const { return materials_->layout(); }
    static VertexLayout vertex_layout();

private:
    struct InstanceData {
        glm::dmat4 world_from_mesh, mesh_from_world;
        bool mirrored = false;
    };
    void upload_meshes(Staging& staging, Scene const& scene);
    void add_items(Scene const& scene);

    Device const& device_;
    glm::dmat4 world_from_scene_;
    double planet_radius_;
    Box bounds_;
    std::vector<GroundPatch> ground_;
    double highest_altitude_ = 0;
    std::size_t triangles_ = 0;
    bool has_masked_ = false;
    std::unique_ptr<GpuBuffer> vertices_, indices_;
    std::vector<std::int32_t> vertex_offsets_;
    std::vector<std::uint32_t> index_offsets_;
    std::vector<InstanceData> instances_;
    std::vector<DrawItem> items_;
    std::unique_ptr<MaterialSets> materials_;
};

} // namespace alpenglow
