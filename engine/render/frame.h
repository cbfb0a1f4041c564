#pragma once

#include "interop/frame.h"
#include "render/cascades.h"
#include "render/ceiling_store.h"
#include "render/frame_graph.h"
#include "render/gpu_scene.h"
#include "render/ground_light.h"
#include "render/terrain_store.h"
#include "scene/view.h"

#include <span>
#include <vector>

namespace alpenglow {

struct AirModel;
struct AirTableStep;
struct StepSlice;
struct TwofoldTable;

/// From what the light on terrain is made: how the sun gets through the air, and the light of all orders.
struct SkyTables {
    ImageId sunlight, orders;
};

/// What the frame's model of the air gives its passes to read.
struct AirTables {
    std::vector<Slot> slots;
    SkyTables over_terrain{}; ///< where the light on terrain is made anew
};

/// Of each pixel, both relative: interop/air.h.
struct AirLayer {
    ImageId inscattered, transmittance;
};

/// The tables of a model of the air, and what a frame makes of them.
struct ModelTables {
    AirModel const& model;
    std::vector<TwofoldTable> const& tables; ///< in the model's order
    std::span<AirTableStep const> steps;     ///< that make them in this air
    std::span<StepSlice const> slices;       ///< of these steps, in this frame
};

/// Light from all round, as the map of the scene has it: interop/terrain_light.h.
struct TerrainLight {
    ImageId surfaces, air;
};

struct SunShadow {
    ImageId cascades;
    ImageId ceiling; ///< beyond them
};

/// What surfaces are drawn into, in the G-buffer's order; precision: interop/gbuffer.h.
inline constexpr VkFormat ALBEDO_FORMAT = VK_FORMAT_R8G8B8A8_SRGB, NORMAL_FORMAT = VK_FORMAT_R16G16B16A16_SNORM,
                          MATERIAL_FORMAT = VK_FORMAT_R8G8B8A8_UNORM, EMISSION_FORMAT = VK_FORMAT_B10G11R11_UFLOAT_PACK32;

struct GBuffer {
    ImageId albedo, normal, material, emission, depth;
};

/// What a frame is made from. Images are owned by the renderer.
struct FrameInputs {
    World const& world;
    Settings const& settings;
    Extent extent;
    GpuScene const* scene = nullptr;   ///< nullptr: the planet alone
    ShadowFit const& shadow;
    CeilingMap const& ceiling;
    TerrainMaps const& terrain;
    std::vector<shader::FrameConstants> const& constants; ///< one for each supersample
    ModelTables const& air;            ///< how it is lit
    ModelTables const* air_ahead;      ///< another model, whose tables are made for frames to come; or nullptr
    GroundAround const& ground;        ///< that lights the air
    GroundAround const& terrain_ground; ///< that lights the air over the terrain, wherever the camera is
    GpuImage& exposure;                ///< one texel: interop/exposure.h
    double seconds;                    ///< since the picture before, by which exposure adapts; ADAPTED_AT_ONCE
    GpuImage& mean;                    ///< radiance, the mean of the supersamples
    GpuImage& picture;                 ///< display-ready, 8 bits
};

/// The frame: declares all passes in data-flow order.
void build_frame(FrameGraph& graph, FrameInputs const& in);

} // namespace alpenglow
