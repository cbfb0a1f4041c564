#include "core/settings.h"
#include "support/files.h"

#include <set>

using namespace alpenglow;
using test::expect_error;

namespace {

/// A value of the setting's type that is in range and not the default.
std::string other_value(SettingInfo const& info) {
    std::string const standard = setting_text(Settings{}, info);
    if (!info.choices.empty()) {
        std::string const first(info.choices.substr(0, info.choices.find('|')));
        return first != standard ? first : std::string(info.choices.substr(info.choices.rfind('|') + 1));
    }
    if (info.member.index() == 0) return standard == "on" ? "off" : "on";
    if (info.member.index() == 3) return "gbuffer.normal";
    return range_text(info).substr(0, range_text(info).find(' '));
}

} // namespace

TEST(Settings, every_field_is_in_the_table_once) {
    std::set<std::string_view> names;
    for (SettingInfo const& info : setting_table()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_FALSE(info.help.empty()) << info.name;
        EXPECT_TRUE(in_range(info, get_setting(Settings{}, info))) << info.name << ": the default is out of range";
    }
    // Bytes are counted, so that a new field without an entry is noticed.
    std::size_t bytes = 0;
    for (SettingInfo const& info : setting_table()) {
        constexpr std::size_t SIZES[] = {sizeof(bool), sizeof(int), sizeof(double), sizeof(std::string)};
        bytes += SIZES[info.member.index()];
    }
    EXPECT_LE(sizeof(Settings) - bytes, 24u) << "more than padding is missing from the table";
}

TEST(Settings, each_is_set_by_its_text_and_changes_only_itself) {
    for (SettingInfo const& info : setting_table()) {
        Settings settings;
        set_setting(settings, info.name, other_value(info));
        EXPECT_EQ(setting_text(settings, info), other_value(info)) << info.name;
        EXPECT_NE(settings, Settings{}) << info.name;
        set_setting(settings, info.name, setting_text(Settings{}, info));
        EXPECT_EQ(settings, Settings{}) << info.name;
    }
}

TEST(Settings, a_real_number_survives_its_text) {
    Settings settings;
    settings.exposure = 1.0 / 3;
    Settings read;
    set_setting(read, "exposure", setting_text(settings, *find_setting("exposure")));
    EXPECT_EQ(read.exposure, settings.exposure);
}

TEST(Settings, bad_ones_are_wrong_use_and_change_nothing) {
    struct Case { std::string name, value; std::vector<std::string> parts; };
    std::vector<Case> const cases{
        {"sampels", "8", {"sampels", "did you mean samples?"}},
        {"zzzzzzzzzz", "8", {"zzzzzzzzzz", "the settings are air, model, air_without, air_phases, samples"}},
        {"samples", "3", {"samples", "\"3\"", "4 to 1024"}},
        {"samples", "1025", {"4 to 1024"}},
        {"samples", "8.5", {"4 to 1024"}},
        {"samples", "", {"4 to 1024"}},
        {"samples", "99999999999999", {"4 to 1024"}},
        {"aa", "2", {"1|4|16"}},
        {"curve", "film", {"filmic|exponential"}},
        {"shadows", "maybe", {"on or off"}},
        {"shafts", "on", {"off|fast|default|exact"}},
        {"exposure", "nan", {"-32 to 32 stops"}},
        {"exposure", "inf", {"-32 to 32 stops"}},
        {"shadow_reach", "-1", {"100 to 10000000 m"}},
    };
    for (Case const& c : cases) {
        Settings settings;
        expect_error(ErrorKind::wrong_use, c.parts, [&] { set_setting(settings, c.name, c.value); });
        EXPECT_EQ(settings, Settings{}) << c.name;
    }
}
