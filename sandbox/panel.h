#pragma once

#include "render/executor.h"
#include "render/passes/overlay.h"
#include "sandbox/keys.h"

#include <string>

namespace alpenglow {

/// What the panel says of the last picture.
struct PictureReport {
    Extent drawn;                 ///< [pixels]
    std::vector<PassTime> passes;
    double exposure = 0;          ///< [stops]
    double exposure_target = 0;   ///< [stops] where it adapts to
};

/// The panel, the help and the messages over the picture, made with Dear ImGui.
class Panel {
public:
    explicit Panel(Window& window);
    ~Panel();
    Panel(Panel const&) = delete;
    Panel& operator=(Panel const&) = delete;

    /// What its triangles are textured with.
    static ByteImage texture();
    /// Takes the mouse and the keyboard of this step.
    void begin();
    bool wants_mouse() const;
    bool wants_keyboard() const;
    /// Lets the user change what `target` says; `message` stands at the lower edge unless it is empty.
    OverlayMesh finish(KeyTarget target, PictureReport const& report, std::string const& message);
};

} // namespace alpenglow
