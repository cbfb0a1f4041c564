#pragma once

#include "reference/path_tracer.h"
#include "scene/view.h"

namespace alpenglow {

enum class SunShape { disc, point };

/// A view as the path tracer sees it: the same planet, scene, camera and sun as the renderer's, and nothing else of it.
/// The sun's disc itself is not in the picture.
class TracedView {
public:
    /// Loads planet and scene. `orders` as in PathTracer::Options. Throws Error.
    TracedView(View const& view, SunShape sun = SunShape::disc, int orders = 0);
    /// The same around another planet than the view's.
    TracedView(View const& view, Planet const& planet, SunShape sun = SunShape::disc, int orders = 0);

    PathTracer const& tracer() const { return tracer_; }
    Camera const& camera() const { return world_.camera; }
    Planet const& planet() const { return world_.planet; }

private:
    std::optional<Scene> scene_;
    World world_;
    Ground ground_;
    PathTracer tracer_;
};

} // namespace alpenglow
