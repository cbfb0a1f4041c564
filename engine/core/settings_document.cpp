#include "core/settings_document.h"

#include "core/settings.h"

#include <fmt/format.h>

namespace alpenglow {

namespace {

constexpr char const* HEAD = R"(# Settings

Everything about a picture that is not the world itself. Each has one name: a key of a view or flight file (switches are `true` or
`false` there), `--set NAME=VALUE` on the command line, and this table, which the program makes from `setting_table()`; a test
keeps it so.

| name | values | default | meaning |
|---|---|---|---|
)";

/// "a|b" as "`a` or `b`": a bar would end the table's cell.
std::string values(SettingInfo const& info) {
    if (info.choices.empty()) return range_text(info);
    std::string text = "`";
    for (char const c : info.choices) text += c == '|' ? "` or `" : std::string(1, c);
    text += '`';
    return text;
}

std::string initial(SettingInfo const& info) {
    std::string const text = setting_text(Settings{}, info);
    return text.empty() ? "empty" : fmt::format("`{}`", text);
}

} // namespace

std::string settings_document() {
    std::string text = HEAD;
    for (SettingInfo const& info : setting_table()) {
        text += fmt::format("| `{}` | {} | {} | {} |\n", info.name, values(info), initial(info), info.help);
    }
    return text;
}

} // namespace alpenglow
