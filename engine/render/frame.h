#pragma once

#include "interop/frame.h"
#include "render/cascades.h"
#include "render/ceiling_store.h"
#include "render/frame_graph.h"
#include "render/gpu_scene.h"
#include "render/ground_light.h"
#include "scene/view.h"

#include <span>
#include <vector>

namespace alpenglow {

struct AirModel;
struct StepSlice;
struct TwofoldTable;

/// What the frame's model of the air gives its passes to read.
struct AirTables {
    std::vector<Slot> slots;
};

/// Of each pixel, both relative: interop/air.h.
struct AirLayer {
    ImageId inscattered, transmittance;
};

/// The tables of a model of the air, and what a frame makes of them.
struct ModelTables {
    AirModel const& model;
    std::vector<TwofoldTable> const& tables; ///< in the model's order
    std::span<StepSlice const> slices;       ///< of the model's steps, that make them in this frame
};

struct SunShadow {
    ImageId cascades;
    ImageId ceiling; ///< beyond them
};

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
    std::vector<shader::FrameConstants> const& constants; ///< one for each supersample
    ModelTables const& air;            ///< how it is lit
    ModelTables const* air_ahead;      ///< another model, whose tables are made for frames to come; or nullptr
    GroundAround const& ground;        ///< that lights the air
    GpuImage& exposure;                ///< one texel: interop/exposure.h
    double seconds;                    ///< since the picture before, by which exposure adapts; ADAPTED_AT_ONCE
    GpuImage& mean;                    ///< radiance, the mean of the supersamples
    GpuImage& picture;                 ///< display-ready, 8 bits
};

/// The frame: declares all passes in data-flow order.
void build_frame(FrameGraph& graph, FrameInputs const& in);

} // namespace alpenglow
