#pragma once

#include "gpu/image.h"
#include "render/ceiling_fit.h"

#include <memory>
#include <optional>

namespace alpenglow {

/// The map of a frame's shadow ceiling.
struct CeilingMap {
    CeilingFit const& fit;
    GpuImage& map;     ///< one lit texel where the fit has no map
    bool is_new;       ///< this frame has to make it
};

/// Keeps the map from frame to frame.
class CeilingStore {
public:
    explicit CeilingStore(Device const& device) : device_(device) {}

    /// Whether the image has the fit's size; else `replace` it, when no frame uses it any more.
    bool fits(CeilingFit const& fit) const;
    void replace(CeilingFit const& fit);
    /// For a frame with this fit, which must live as long.
    CeilingMap of(CeilingFit const& fit) const { return {fit, *map_, fit.size > 0 && made_ != fit}; }
    /// Such a frame was submitted.
    void finish(CeilingFit const& fit) { made_ = fit; }
    /// From now on it holds nothing: the scene is another, or the making is to be measured.
    void discard() { made_.reset(); }
    /// nullptr before the first frame.
    GpuImage* map() const { return map_.get(); }

private:
    Device const& device_;
    std::unique_ptr<GpuImage> map_;
    std::optional<CeilingFit> made_;
};

} // namespace alpenglow
