#pragma once

#include "interop/frame.h"
#include "render/cascades.h"
#include "render/frame_graph.h"
#include "render/gpu_scene.h"
#include "scene/view.h"

namespace alpenglow {

/// Tables of the air; they outlive the frame and are made anew when `stale`.
struct AirTables {
    ImageId transmittance, multiple_scattering;
};

struct SunShadow {
    ImageId cascades;
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
    std::vector<shader::FrameConstants> const& constants; ///< one for each supersample
    GpuImage& transmittance;
    GpuImage& multiple_scattering;
    bool air_is_stale = true;
    GpuImage& exposure;                ///< one texel: interop/exposure.h
    double seconds;                    ///< since the picture before, by which exposure adapts; ADAPTED_AT_ONCE
    GpuImage& mean;                    ///< radiance, the mean of the supersamples
    GpuImage& picture;                 ///< display-ready, 8 bits
};

/// The frame: declares all passes in data-flow order.
void build_frame(FrameGraph& graph, FrameInputs const& in);

} // namespace alpenglow
