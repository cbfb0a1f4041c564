#include "sandbox/keys.h"

#include <algorithm>
#include <array>

namespace alpenglow {

namespace {

constexpr double ROLL_RATE = 0.8; // [rad/s]
constexpr double BOOST = 8;       // of the speed, with Shift

void flip(bool& setting) { setting = !setting; }

/// Of the fixed exposure, or what is added to the automatic one.
void change_exposure(Settings& settings, double stops) {
    bool const automatic = settings.auto_exposure;
    SettingInfo const& info = *find_setting(automatic ? "exposure_compensation" : "exposure");
    double& value = automatic ? settings.exposure_compensation : settings.exposure;
    value = std::clamp(value + stops, info.smallest, info.largest);
}

/// The result comes first, then every image of the frame.
void cycle_images(KeyTarget& target, int direction) {
    std::vector<std::string> names = {""};
    names.insert(names.end(), target.screen.images.begin(), target.screen.images.end());
    std::string& shown = target.pilot.settings().show;
    auto const now = std::ranges::find(names, shown) - names.begin();
    auto const count = static_cast<std::ptrdiff_t>(names.size());
    shown = names[static_cast<std::size_t>((now % count + direction + count) % count)];
}

/// In the order in which the setting lists them.
void cycle_models(KeyTarget& target, int direction) {
    SettingInfo const& info = *find_setting("model");
    std::vector<std::string> const names = choices_of(info);
    auto const now = std::ranges::find(names, target.pilot.settings().model) - names.begin();
    auto const count = static_cast<std::ptrdiff_t>(names.size());
    target.pilot.settings().model = names[static_cast<std::size_t>((now + direction + count) % count)];
}

void show_cascades(KeyTarget& target, int, bool) {
    std::string& shown = target.pilot.settings().show;
    shown = shown == "cascades" ? "" : "cascades";
}

void flip_post_aa(KeyTarget& target, int, bool) {
    std::string& filter = target.pilot.settings().post_aa;
    filter = filter == "none" ? "fxaa" : "none";
}

constexpr std::array ROWS = {
    KeyRow{"mouse, a button held", "look around"},
    KeyRow{"wheel", "field of view"},
    KeyRow{"W A S D", "fly ahead, left, back, right"},
    KeyRow{"E Q", "up, down"},
    KeyRow{"Z X", "roll left, right"},
    KeyRow{"Shift", "8 times as fast; larger steps"},
    KeyRow{"[ ]", "sun: 10 minutes back, on (Shift: an hour)", ']', '[',
           [](KeyTarget& t, int direction, bool shift) { t.pilot.add_sun_hours(direction * (shift ? 1 : 1.0 / 6)); }},
    KeyRow{"; '", "sun: 5 days back, on (Shift: 30)", '\'', ';',
           [](KeyTarget& t, int direction, bool shift) { t.pilot.add_sun_days(direction * (shift ? 30 : 5)); }},
    KeyRow{"- =", "exposure: a quarter stop down, up (Shift: one)", '=', '-',
           [](KeyTarget& t, int direction, bool shift) {
               change_exposure(t.pilot.settings(), direction * (shift ? 1 : 0.25));
           }},
    KeyRow{"0", "automatic exposure on, off", '0', 0,
           [](KeyTarget& t, int, bool) { flip(t.pilot.settings().auto_exposure); }},
    KeyRow{"1", "air on, off", '1', 0, [](KeyTarget& t, int, bool) { flip(t.pilot.settings().air); }},
    KeyRow{"2", "light shafts on, off", '2', 0,
           [](KeyTarget& t, int, bool) {
               std::string& shafts = t.pilot.settings().shafts;
               shafts = shafts == "off" ? "default" : "off";
           }},
    KeyRow{"3", "shadows on, off", '3', 0, [](KeyTarget& t, int, bool) { flip(t.pilot.settings().shadows); }},
    KeyRow{"4", "antialiasing filter on, off", '4', 0, flip_post_aa},
    KeyRow{"M", "the next model of the air (Shift: the one before)", 'M', 0,
           [](KeyTarget& t, int, bool shift) { cycle_models(t, shift ? -1 : 1); }},
    KeyRow{"C", "which cascade shades what", 'C', 0, show_cascades},
    KeyRow{"I O", "the next, the previous image of the frame", 'I', 'O',
           [](KeyTarget& t, int direction, bool) { cycle_images(t, direction); }},
    KeyRow{"P or F2", "save the picture and its view file", 'P', key::F2,
           [](KeyTarget& t, int, bool) { t.screen.save = true; }},
    KeyRow{"Tab", "panel", key::TAB, 0, [](KeyTarget& t, int, bool) { flip(t.screen.panel); }},
    KeyRow{"H or F1", "this help", 'H', key::F1, [](KeyTarget& t, int, bool) { flip(t.screen.help); }},
    KeyRow{"Esc", "leave"},
};

} // namespace

std::span<KeyRow const> key_rows() { return ROWS; }

void act_on_keys(KeyTarget target, std::vector<KeyPress> const& pressed) {
    for (auto const [key, shift] : pressed) {
        for (KeyRow const& row : ROWS) {
            if (row.act && (key == row.more || key == row.less)) row.act(target, key == row.more ? 1 : -1, shift);
        }
    }
}

FlyInput held_input(Window const& window, WindowEvents const& events, double dt) {
    // A tap within one slow frame is over before anyone looks.
    auto const held = [&](int key) { return window.is_down(key) || events.has_pressed(key); };
    auto const axis = [&](int more, int less) { return double(held(more)) - double(held(less)); };
    FlyInput input;
    input.move = {axis('D', 'A'), axis('E', 'Q'), axis('W', 'S')};
    input.roll = axis('X', 'Z') * ROLL_RATE * dt;
    input.boost = window.shift() ? BOOST : 1;
    return input;
}

} // namespace alpenglow
