#pragma once

#include "render/renderer.h"
#include "sandbox/commands.h"
#include "scene/view.h"

#include <memory>

namespace alpenglow {

/// A device with a renderer, and the planet and scene that stand on it: what all commands that draw have in common. Planets
/// and scenes are loaded when a view first asks for them.
class Stage {
public:
    explicit Stage(DrawOptions const& options, DeviceOptions device = {}, std::uint32_t frames_in_flight = 1);

    Device const& device() const { return device_; }
    Renderer& renderer() { return renderer_; }

    /// The view with the command line's words laid over it.
    View dressed(View view) const;
    /// Loads what the view needs, and gives the world to draw. Throws Error.
    World prepare(View const& view);
    /// Draws the world as the view says. Throws Error; a view file that shows an image which does not exist is bad input.
    void draw(View const& view, World const& world, Extent size);
    /// Throws Error(device) where validation was asked for and said anything.
    void require_no_messages() const;

private:
    bool overrides(std::string_view setting) const;
    void require_scene(View const& view);

    DrawOptions options_;
    Device device_;
    Renderer renderer_;
    std::string planet_name_;
    Planet planet_;
    std::string scene_key_;
};

} // namespace alpenglow
