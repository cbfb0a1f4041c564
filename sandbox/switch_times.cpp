#include "sandbox/switch_times.h"

#include "sandbox/median.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace alpenglow {

namespace {

constexpr int USUAL_FRAMES = 5;                  // whose median is the usual frame
constexpr double SWING = 0.05, SWING_STEP = 0.1; // [rad] of the camera, and of its phase from frame to frame

double milliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class SwitchRound {
public:
    SwitchRound(DrawOptions const& options, View const& view, Extent size)
        : stage_(options, {}, 1, Switches::when_ready), view_(stage_.dressed(view)),
          heading_(view_.camera.heading), size_(size) {}

    /// A frame when all is done that is done ahead.
    double usual_frame() {
        do frame();
        while (!is_ready());
        std::vector<double> times;
        for (int i = 0; i < USUAL_FRAMES; ++i) times.push_back(frame());
        return median(times);
    }
    SwitchTimes make(Switch const& change) {
        double const start = milliseconds();
        set_setting(view_.settings, change.name, change.value);
        SwitchTimes times;
        do times.longest_ms = std::max(times.longest_ms, frame());
        while (!renderer().settings_shown());
        times.shown_ms = milliseconds() - start;
        while (!renderer().tables_finished()) times.longest_ms = std::max(times.longest_ms, frame());
        times.tables_ms = milliseconds() - start;
        return times;
    }
    Device const& device() const { return stage_.device(); }
    void finish() const { stage_.require_no_messages(); }

private:
    Renderer& renderer() { return stage_.renderer(); }
    bool is_ready() {
        return renderer().settings_shown() && renderer().switches_prepared() && renderer().switches_rehearsed() &&
               renderer().tables_finished() && renderer().tables_ahead_finished();
    }
    /// From its planning to the end of its work on the device [ms].
    double frame() {
        double const start = milliseconds();
        view_.camera.heading = heading_ + SWING * std::sin(SWING_STEP * frames_++);
        stage_.draw(view_, stage_.prepare(view_), size_);
        renderer().wait();
        return milliseconds() - start;
    }

    Stage stage_;
    View view_;
    double heading_; ///< [rad] in the middle
    Extent size_;
    int frames_ = 0;
};

SwitchTimes medians(std::vector<SwitchTimes> const& rounds) {
    SwitchTimes result;
    for (auto const member : {&SwitchTimes::frame_ms, &SwitchTimes::longest_ms, &SwitchTimes::shown_ms,
                              &SwitchTimes::tables_ms, &SwitchTimes::after_ms}) {
        std::vector<double> values;
        for (SwitchTimes const& times : rounds) values.push_back(times.*member);
        result.*member = median(values);
    }
    return result;
}

} // namespace

std::vector<Switch> const& measured_switches() {
    static std::vector<Switch> const SWITCHES{
        {"shafts", "fast"},
        {"shafts", "exact"},
        {"shafts", "off"},
        {"shafts", "default"},
        {"soft_shafts", "on"},
        {"soft_shafts", "off"},
        {"multiple_scattering", "off"},
        {"multiple_scattering", "on"},
        {"air_stride", "1"},
        {"air_stride", "auto"},
        {"model", "naive"},
        {"model", "tables"},
        {"model", "march"},
        {"air", "off"},
        {"air", "on"},
        {"air_without", "ozone"},
        {"air_without", ""},
        {"air_phases", "aerosol=henyey_greenstein:0.6"},
        {"air_phases", ""},
        {"shadows", "off"},
        {"shadows", "on"},
        {"ambient_occlusion", "off"},
        {"ambient_occlusion", "on"},
        {"auto_exposure", "on"},
        {"auto_exposure", "off"},
        {"curve", "aces"},
        {"post_aa", "none"},
        {"post_aa", "fxaa"},
        {"show", "normal"},
        {"show", ""},
    };
    return SWITCHES;
}

SwitchReport time_switches(DrawOptions const& options, View const& view, Extent size, int rounds,
                           std::function<void()> const& before_switch) {
    std::vector<Switch> const& switches = measured_switches();
    std::vector<std::vector<SwitchTimes>> samples(switches.size());
    SwitchReport report;
    for (int i = 0; i < rounds; ++i) {
        SwitchRound round(options, view, size);
        double usual = round.usual_frame();
        for (std::size_t j = 0; j < switches.size(); ++j) {
            before_switch();
            SwitchTimes& times = samples[j].emplace_back(round.make(switches[j]));
            times.frame_ms = usual;
            times.after_ms = usual = round.usual_frame();
        }
        report.device = round.device().name(), report.driver = round.device().driver();
        round.finish();
    }
    for (std::vector<SwitchTimes> const& of_one : samples) report.times.push_back(medians(of_one));
    return report;
}

} // namespace alpenglow
