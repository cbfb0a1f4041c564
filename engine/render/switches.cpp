#include "render/switches.h"

#include <algorithm>

namespace alpenglow {

namespace {

std::vector<std::string> values_of(Settings const& settings, SettingInfo const& info) {
    if (std::holds_alternative<bool>(get_setting(settings, info))) return {"on", "off"};
    return choices_of(info);
}

} // namespace

bool same_choices(Settings const& a, Settings const& b) {
    return std::ranges::all_of(setting_table(), [&](SettingInfo const& info) {
        return values_of(a, info).empty() || get_setting(a, info) == get_setting(b, info);
    });
}

std::vector<Settings> one_choice_away(Settings const& settings) {
    std::vector<Settings> result;
    for (SettingInfo const& info : setting_table()) {
        for (std::string const& value : values_of(settings, info)) {
            if (value == setting_text(settings, info)) continue;
            result.push_back(settings);
            result.back().show.clear();
            set_setting(result.back(), info.name, value);
        }
    }
    return result;
}

} // namespace alpenglow
