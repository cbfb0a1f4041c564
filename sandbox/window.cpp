#include "sandbox/window.h"

#include "core/error.h"
#include "core/log.h"

#define GLFW_INCLUDE_NONE
#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <algorithm>
#include <cstdlib>

namespace alpenglow {

static_assert(key::ESCAPE == GLFW_KEY_ESCAPE && key::TAB == GLFW_KEY_TAB && key::F1 == GLFW_KEY_F1 &&
              key::F2 == GLFW_KEY_F2 && key::LEFT_SHIFT == GLFW_KEY_LEFT_SHIFT &&
              key::RIGHT_SHIFT == GLFW_KEY_RIGHT_SHIFT);

namespace {

bool has_display() {
    auto const set = [](char const* name) { return std::getenv(name) && *std::getenv(name); };
    return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

std::string last_glfw_error() {
    char const* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason was given";
}

GLFWwindow* make_window(Extent size, std::string const& title) {
    if (!glfwInit() || !glfwVulkanSupported()) return nullptr;
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    return glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height), title.c_str(), nullptr,
                            nullptr);
}

} // namespace

struct Window::Callbacks {
    static Window& window(GLFWwindow* handle) { return *static_cast<Window*>(glfwGetWindowUserPointer(handle)); }

    static void key(GLFWwindow* handle, int key, int, int action, int modifiers) {
        if (key < 0 || static_cast<std::size_t>(key) >= KEYS) return;
        Window& self = window(handle);
        self.down_[static_cast<std::size_t>(key)] = action != GLFW_RELEASE;
        if (action != GLFW_RELEASE) self.events_.pressed.push_back({key, (modifiers & GLFW_MOD_SHIFT) != 0});
    }
    static void button(GLFWwindow* handle, int, int action, int) {
        Window& self = window(handle);
        self.buttons_down_ += action == GLFW_PRESS ? 1 : -1;
        if (action == GLFW_PRESS) self.events_.button_pressed = true;
    }
    static void move(GLFWwindow* handle, double x, double y) {
        Window& self = window(handle);
        glm::dvec2 const moved = self.mouse_known_ ? glm::dvec2(x, y) - self.mouse_ : glm::dvec2(0);
        self.events_.mouse_moved += moved;
        if (self.button_down()) self.events_.mouse_dragged += moved;
        self.mouse_ = {x, y};
        self.mouse_known_ = true;
    }
    static void enter(GLFWwindow* handle, int entered) {
        if (entered) window(handle).mouse_known_ = false;
    }
    static void scroll(GLFWwindow* handle, double, double notches) { window(handle).events_.wheel += notches; }
    static void resize(GLFWwindow* handle, int, int) { window(handle).events_.resized = true; }
    static void iconify(GLFWwindow* handle, int) { window(handle).events_.resized = true; }
};

std::unique_ptr<Window> Window::open(Extent size, std::string const& title) {
    if (!has_display()) return nullptr;
    if (GLFWwindow* const window = make_window(size, title)) return std::unique_ptr<Window>(new Window(window));
    log_warning("no window can be opened (" + last_glfw_error() + "); going on without one");
    glfwTerminate();
    return nullptr;
}

Window::Window(GLFWwindow* window) : window_(window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, Callbacks::key);
    glfwSetMouseButtonCallback(window, Callbacks::button);
    glfwSetCursorPosCallback(window, Callbacks::move);
    glfwSetCursorEnterCallback(window, Callbacks::enter);
    glfwSetScrollCallback(window, Callbacks::scroll);
    glfwSetFramebufferSizeCallback(window, Callbacks::resize);
    glfwSetWindowIconifyCallback(window, Callbacks::iconify);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

DeviceOptions Window::device_options() const {
    DeviceOptions options;
    std::uint32_t count = 0;
    char const** const names = glfwGetRequiredInstanceExtensions(&count);
    if (!names) throw Error(ErrorKind::device, "Vulkan can't draw to windows here", {}, "use --headless");
    options.instance_extensions.assign(names, names + count);
    options.make_surface = [window = window_](VkInstance instance) {
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        check(glfwCreateWindowSurface(instance, window, nullptr, &surface), "preparing the window");
        return surface;
    };
    return options;
}

WindowEvents Window::poll(double patience) {
    events_ = {};
    if (patience > 0) {
        glfwWaitEventsTimeout(patience);
    } else {
        glfwPollEvents();
    }
    return events_;
}

bool Window::close_requested() const { return glfwWindowShouldClose(window_); }

void Window::request_close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

Extent Window::framebuffer() const {
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return {};
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

double Window::height() const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    return std::max(height, 1);
}

double Window::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return y > 0 ? y : 1;
}

void Window::capture_mouse(bool capture) {
    glfwSetInputMode(window_, GLFW_CURSOR, capture ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    glfwGetCursorPos(window_, &mouse_.x, &mouse_.y); // a jump of the cursor is no move of the mouse
}

} // namespace alpenglow
