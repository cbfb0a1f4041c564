#pragma once

#include "render/renderer.h"
#include "sandbox/commands.h"
#include "scene/ground_query.h"
#include "scene/view.h"

#include <memory>
#include <set>

namespace alpenglow {

/// A device with a renderer, and the planet and scene that stand on it: what all commands that draw have in common.
/// Planets and scenes are loaded when a view first asks for them.
class Stage {
public:
    explicit Stage(DrawOptions const& options, DeviceOptions device = {}, std::uint32_t frames_in_flight = 1,
                   Switches switches = Switches::at_once);

    Device const& device() const { return device_; }
    Renderer& renderer() { return renderer_; }

    /// The view with the command line's words laid over it.
    View dressed(View view) const;
    /// Loads what the view needs, and gives the world to draw. Throws Error.
    World prepare(View const& view);
    /// Draws the world as the view says, and once in a line what the model of the air leaves out there. Throws Error; a view file that shows an image which does not exist is bad
    /// input.
    void draw(View const& view, World const& world, Extent size, Renderer::Finish const& finish = {},
              PresentSync const& sync = {});
    /// Of the view prepared last.
    Planet const& planet() const { return planet_; }
    /// From the next scene on, `ground_altitude` knows it.
    void follow_ground() { follows_ground_ = true; }
    /// Of what stands under (or over) a place in the world [m]: the scene, or the planet's radius, 0.
    double ground_altitude(glm::dvec3 const& world) const;
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
    std::vector<SceneCamera> cameras_; ///< of that scene
    bool follows_ground_ = false;
    std::optional<GroundQuery> ground_;
    std::set<std::string> said_; ///< limits of models, each a line once
};

} // namespace alpenglow
