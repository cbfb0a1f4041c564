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

    /// The next frame with this fit reads it; `wait` is called before an image is replaced.
    CeilingMap of(CeilingFit const& fit, auto const& wait) {
        if (!fits(fit)) wait(), replace(fit);
        bool const is_new = fit.size > 0 && made_ != fit;
        made_ = fit;
        return {*made_, *map_, is_new};
    }
    /// From now on it holds nothing: the scene is another, or the making is to be measured.
    void discard() { made_.reset(); }
    /// nullptr before the first frame.
    GpuImage* map() const { return map_.get(); }

private:
    bool fits(CeilingFit const& fit) const;
    void replace(CeilingFit const& fit);

    Device const& device_;
    std::unique_ptr<GpuImage> map_;
    std::optional<CeilingFit> made_;
};

} // namespace alpenglow
