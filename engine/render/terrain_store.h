#pragma once

#include "gpu/image.h"
#include "render/ceiling_fit.h"
#include "render/terrain_fit.h"

#include <memory>
#include <optional>

namespace alpenglow {

/// What the light on terrain follows from, beside tables of the air.
struct TerrainLightCause {
    TerrainFit fit;
    CeilingFit ceiling; ///< knows the sun
    shader::Atmosphere air;

    bool operator==(TerrainLightCause const& other) const;
};

/// The images of a frame's map of the light on terrain.
struct TerrainMaps {
    TerrainLightCause const& cause;
    GpuImage &albedo, &normal, &depth; ///< the scene from above
    GpuImage &light, &air;             ///< one black texel where there is no map
    bool scene_is_new;                 ///< this frame has to draw the scene from above
    bool light_is_new;                 ///< and to make the light

    TerrainFit const& fit() const { return cause.fit; }
};

/// Keeps the map from frame to frame.
class TerrainStore {
public:
    explicit TerrainStore(Device const& device) : device_(device) {}

    /// Whether the images have the fit's size; else `replace` them, when no frame uses them any more.
    bool fits(TerrainFit const& fit) const;
    void replace(TerrainFit const& fit);
    /// For a frame with this cause, which must live as long. `tables_change`: what it follows from is just being made.
    TerrainMaps of(TerrainLightCause const& cause, bool tables_change) const;
    /// Such a frame was submitted.
    void finish(TerrainMaps const& maps);
    /// From now on it holds nothing: the scene is another, or the making is to be measured.
    void discard() { drawn_.reset(), made_.reset(); }
    /// nullptr before the first frame.
    GpuImage* light() const { return light_.get(); }

private:
    Device const& device_;
    std::unique_ptr<GpuImage> albedo_, normal_, depth_, light_, air_;
    std::optional<TerrainFit> drawn_;
    std::optional<TerrainLightCause> made_;
};

} // namespace alpenglow
