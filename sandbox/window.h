#pragma once

#include "core/extent.h"
#include "gpu/device.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace alpenglow {

/// Keys by their place on a US keyboard: those with a letter or sign are its upper-case ASCII code, the others are
/// here.
namespace key {
inline constexpr int ESCAPE = 256, TAB = 258, F1 = 290, F2 = 291, LEFT_SHIFT = 340, RIGHT_SHIFT = 344;
}

/// A key that went down, and whether Shift was down then: on a slow device both may be up again when anyone looks.
struct KeyPress {
    int key;
    bool shift;
};

/// What happened between two polls.
struct WindowEvents {
    std::vector<KeyPress> pressed; ///< repeats of held keys included
    glm::dvec2 mouse_moved{0};     ///< [screen units] right, down
    glm::dvec2 mouse_dragged{0};   ///< [screen units] what of it was with a button down
    double wheel = 0;              ///< notches, away from the user
    bool button_pressed = false;   ///< any of the mouse
    bool resized = false;          ///< the framebuffer has another size now

    bool has_pressed(int key) const { return std::ranges::find(pressed, key, &KeyPress::key) != pressed.end(); }
};

/// A window with its keyboard and mouse. The only file that knows GLFW is its source.
class Window {
public:
    /// Nothing where there is no display, or, after one line of warning, where the display gives no window.
    static std::unique_ptr<Window> open(Extent size, std::string const& title);
    ~Window();
    Window(Window const&) = delete;
    Window& operator=(Window const&) = delete;

    /// What a device needs to draw to this window; the window has to outlive the device.
    DeviceOptions device_options() const;
    GLFWwindow* native() const { return window_; }

    /// Collects what happened since the last call; waits for something at most `patience` [s].
    WindowEvents poll(double patience = 0);
    bool is_down(int key) const { return down_[static_cast<std::size_t>(key)]; }
    bool shift() const { return is_down(key::LEFT_SHIFT) || is_down(key::RIGHT_SHIFT); }
    bool button_down() const { return buttons_down_ > 0; }
    bool close_requested() const;
    void request_close();

    Extent framebuffer() const;   ///< [pixels]; empty while minimized
    double height() const;        ///< [screen units] as the mouse moves
    double content_scale() const; ///< pixels of the framebuffer for each pixel of a plain screen
    /// Hides the mouse and keeps it in the window, so that it can move without end.
    void capture_mouse(bool capture);

private:
    explicit Window(GLFWwindow* window);
    struct Callbacks;

    static constexpr std::size_t KEYS = 349;
    GLFWwindow* window_;
    WindowEvents events_;
    std::vector<bool> down_ = std::vector<bool>(KEYS);
    int buttons_down_ = 0;
    glm::dvec2 mouse_{0};
    bool mouse_known_ = false; ///< false: the next place of the mouse is a new start, not a move
};

} // namespace alpenglow
