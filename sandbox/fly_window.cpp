#include "sandbox/fly.h"

#include "core/error.h"
#include "core/log.h"
#include "gpu/swapchain.h"
#include "render/models/models.h"
#include "render/passes/overlay.h"
#include "render/passes/present.h"
#include "render/passes/show.h"
#include "sandbox/panel.h"
#include "sandbox/render_scale.h"
#include "sandbox/saved_views.h"

#include <chrono>
#include <cmath>
#include <utility>

namespace alpenglow {

namespace {

constexpr std::uint32_t FRAMES_IN_FLIGHT = 2;
constexpr double IDLE_PATIENCE = 0.1; // [s] between looks at a picture that stands still
constexpr double MESSAGE_TIME = 5;    // [s]
constexpr double ADAPTED = 0.01;      // [stops] that nobody sees
constexpr double JITTER = 16;         // [screen units] a mouse that moves less from its place was only touched
constexpr double WHEEL_ZOOM = 0.9;    // of the field of view, for a notch
char const* const SAVED_VIEWS = "out/views";
char const* const HINT = "Any key or the mouse takes over; H shows the keys";

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

class WindowFlight {
public:
    WindowFlight(FlyOptions const& options, Flight const& flight, Window& window)
        : window_(window), stage_(options, window.device_options(), FRAMES_IN_FLIGHT, Switches::when_ready), panel_(window),
          pilot_(stage_, flight), overlay_(stage_.device(), Panel::texture(), FRAMES_IN_FLIGHT),
          swapchain_(stage_.device(), window.framebuffer(), FRAMES_IN_FLIGHT) {
        stage_.follow_ground();
        world_ = stage_.prepare(pilot_.view());
        then_ = seconds();
    }

    void run() {
        while (!window_.close_requested()) step();
        stage_.renderer().wait();
        stage_.require_no_messages();
    }

private:
    void step();
    void steer(WindowEvents const& events, double dt);
    FlyInput look(WindowEvents const& events);
    bool takes_over(WindowEvents const& events);
    bool fit_window(WindowEvents const& events);
    Extent choose_size();
    void draw(Extent size);
    void draw_view(Extent size, Renderer::Finish const& finishing, PresentSync const& sync);
    void finish(FrameGraph& graph, ImageId picture, GpuImage& target);
    void note_times();
    void note_exposure();
    bool stands_still();
    void save();
    void say(std::string message);
    std::string message() const;
    KeyTarget target() { return {pilot_, screen_}; }

    Window& window_;
    Stage stage_;
    Panel panel_;
    Pilot pilot_;
    Overlay overlay_;
    Swapchain swapchain_;
    World world_;
    Screen screen_;
    RenderScale scale_;
    PictureReport report_;
    OverlayMesh mesh_;

    double then_ = 0;          ///< [s] when the last step began
    glm::dvec2 mouse_path_{0}; ///< since the start
    bool looking_ = false;     ///< a button that went down on the picture is held
    bool stale_swapchain_ = false;
    std::string drawn_;  ///< the view of the picture, as text: the same text is the same picture
    bool moving_ = true; ///< the view is another one than in the last step
    double undrawn_ = 0; ///< [s] since the last picture
    double exposure_noted_ = 0; ///< [s]
    std::string message_;
    double message_end_ = 0; ///< [s]
};

void WindowFlight::step() {
    bool const idle = !moving_ && stands_still();
    WindowEvents const events = window_.poll(idle ? IDLE_PATIENCE : 0);
    if (!fit_window(events)) {
        window_.poll(IDLE_PATIENCE);
        then_ = seconds(); // time stands still while there is nothing to see
        return;
    }
    double const now = seconds(), dt = now - std::exchange(then_, now);
    std::string const before = view_text(pilot_.view());
    panel_.begin();
    steer(events, dt);
    mesh_ = panel_.finish(target(), report_, message());
    moving_ = view_text(pilot_.view()) != before;
    world_ = stage_.prepare(pilot_.view());
    screen_.model_limits = model_limits(world_, pilot_.settings(), stage_.renderer().scene() != nullptr);
    if (std::exchange(screen_.save, false)) save();
    undrawn_ += dt;
    draw(choose_size());
}

/// Whether the next picture would be the last one again.
bool WindowFlight::stands_still() {
    bool const adapting = std::abs(report_.exposure_target - report_.exposure) > ADAPTED;
    return drawn_ == view_text(pilot_.view()) && !adapting && stage_.renderer().tables_finished() &&
           stage_.renderer().settings_shown();
}

bool WindowFlight::fit_window(WindowEvents const& events) {
    if (events.resized || stale_swapchain_ || swapchain_.extent().pixels() == 0)
        swapchain_.resize(window_.framebuffer());
    stale_swapchain_ = false;
    return swapchain_.extent().pixels() > 0;
}

void WindowFlight::steer(WindowEvents const& events, double dt) {
    if (takes_over(events)) {
        pilot_.take_over();
        screen_.panel = true;
    }
    bool const typing = panel_.wants_keyboard();
    if (!typing && events.has_pressed(key::ESCAPE)) window_.request_close();
    FlyInput input = look(events);
    if (!typing) {
        act_on_keys(target(), events.pressed);
        FlyInput const held = held_input(window_, events, dt);
        input.move = held.move, input.roll = held.roll, input.boost = held.boost;
    }
    if (events.wheel != 0 && !panel_.wants_mouse())
        pilot_.set_vertical_fov(pilot_.view().camera.vertical_fov * std::pow(WHEEL_ZOOM, events.wheel));
    pilot_.advance(dt, input);
}

bool WindowFlight::takes_over(WindowEvents const& events) {
    if (pilot_.user_flies()) return false;
    mouse_path_ += events.mouse_moved;
    return !events.pressed.empty() || events.button_pressed || events.wheel != 0 || glm::length(mouse_path_) > JITTER;
}

/// The mouse turns the camera as far as the picture is wide under it, while a button is held.
FlyInput WindowFlight::look(WindowEvents const& events) {
    bool const looked = looking_ || (events.button_pressed && !panel_.wants_mouse());
    bool const looks = looked && window_.button_down();
    if (looks != std::exchange(looking_, looks)) window_.capture_mouse(looks);
    FlyInput input;
    if (!looked) return input;
    double const radians = pilot_.view().camera.vertical_fov / window_.height();
    input.yaw = events.mouse_dragged.x * radians;
    input.pitch = -events.mouse_dragged.y * radians;
    return input;
}

Extent WindowFlight::choose_size() {
    double const share = screen_.adapt_share ? scale_.share(moving_) : 1;
    return scaled(swapchain_.extent(), share);
}

void WindowFlight::draw(Extent size) {
    auto const target = swapchain_.acquire();
    if (!target) {
        stale_swapchain_ = true;
        return;
    }
    auto const finishing = [&](FrameGraph& graph, ImageId picture) { finish(graph, picture, *target->image); };
    PresentSync const sync{target->acquired, target->finished};
    bool const same = stands_still() && size == report_.drawn;
    if (same) {
        stage_.renderer().finish_again(finishing, sync);
    } else {
        if (!drawn_.empty()) stage_.renderer().pass_time(std::exchange(undrawn_, 0));
        draw_view(size, finishing, sync);
        drawn_ = view_text(pilot_.view());
        report_.drawn = size;
    }
    stale_swapchain_ = !swapchain_.present();
    // A frame ahead gains nothing where the device is this processor, and the user feels it as a lag.
    if (stage_.device().is_software()) stage_.renderer().wait();
    note_times();
}

/// Of settings that have taken away the image that is shown, the result is drawn.
void WindowFlight::draw_view(Extent size, Renderer::Finish const& finishing, PresentSync const& sync) {
    std::string& shown = pilot_.settings().show;
    try {
        stage_.draw(pilot_.view(), world_, size, finishing, sync);
    } catch (Error const& error) {
        if (error.kind() == ErrorKind::device || shown.empty() || drawn_.empty()) throw;
        say("no image '" + std::exchange(shown, {}) + "' here");
        stage_.draw(pilot_.view(), world_, size, finishing, sync);
    }
}

void WindowFlight::finish(FrameGraph& graph, ImageId picture, GpuImage& target) {
    // A frame that only shows its picture again has no other images.
    if (graph.images().size() > 1) screen_.images = shown_names(graph);
    ImageId const window = graph.import(target, "window", ShowScale::encoded, false);
    add_present(graph, picture, window, swapchain_.encodes_srgb());
    overlay_.add(graph, window, std::move(mesh_), swapchain_.encodes_srgb());
    graph.present(window);
}

/// Times of a whole frame; those of a picture shown again say nothing.
void WindowFlight::note_times() {
    double of_pixels = 0;
    bool whole = false;
    for (PassTime const& pass : stage_.renderer().timings()) {
        whole = whole || pass.name == "lighting";
        if (pass.name != "sun_shadow" && !table_passes().contains(pass.name)) of_pixels += pass.gpu_ms;
    }
    if (!whole) return;
    note_exposure();
    report_.passes = stage_.renderer().timings();
    scale_.note(of_pixels, double(report_.drawn.width) / swapchain_.extent().width);
}

/// Reading it waits for the device: seldom, as long as there is another picture anyway.
void WindowFlight::note_exposure() {
    if (moving_ && seconds() < exposure_noted_ + 0.2) return;
    exposure_noted_ = seconds();
    shader::ExposureState const exposure = stage_.renderer().exposure();
    report_.exposure = double(exposure.stops), report_.exposure_target = double(exposure.target);
}

/// The picture in the window's full size, without the panel.
void WindowFlight::save() {
    stage_.renderer().pass_time(0); // as it is seen
    View finished = pilot_.view();
    finished.settings.spread_tables = false;
    do stage_.draw(finished, world_, swapchain_.extent());
    while (!stage_.renderer().settings_shown());
    try {
        say("saved " + save_view(SAVED_VIEWS, pilot_.view(), stage_.renderer().picture()).string());
        log_info(message_);
    } catch (Error const& error) {
        say(error.what());
        log_warning(message_);
    }
    report_.drawn = {}; // the renderer's picture is another one now
}

void WindowFlight::say(std::string message) {
    message_ = std::move(message);
    message_end_ = seconds() + MESSAGE_TIME;
}

std::string WindowFlight::message() const {
    if (seconds() < message_end_) return message_;
    return pilot_.user_flies() ? "" : HINT;
}

} // namespace

void fly_in_window(FlyOptions const& options, Flight const& flight, Window& window) {
    WindowFlight(options, flight, window).run();
}

} // namespace alpenglow
