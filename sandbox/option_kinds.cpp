#include "sandbox/option_kinds.h"

#include "core/error.h"

namespace alpenglow {

CLI::Option* add_value(CLI::App& app, std::string const& name, std::string const& value, Take take,
                       std::string const& help) {
    return app
        .add_option_function<std::vector<std::string>>(
            name,
            [name, take = std::move(take)](std::vector<std::string> const& given) {
                for (std::string const& text : given) {
                    if (text.starts_with("--")) throw Error(ErrorKind::wrong_use, name + " needs a value");
                    take(text);
                }
            },
            help)
        ->expected(1)
        ->allow_extra_args(false)
        ->type_name(value);
}

void add_list(CLI::App& app, std::string const& name, std::string const& value,
              std::function<void(std::vector<std::string> const&)> take, std::string const& help) {
    app.add_option_function<std::vector<std::string>>(name, std::move(take), help)->expected(1, -1)->type_name(value);
}

void add_whole(CLI::App& app, std::string const& name, int& value, std::string const& help, int smallest, int largest) {
    add_value(
        app, name, "N",
        [&value, name, smallest, largest](std::string const& t) {
            value = static_cast<int>(parse_integer(name, t, smallest, largest));
        },
        help);
}

void add_path(CLI::App& app, std::string const& name, std::string const& value, std::filesystem::path& path,
              std::string const& help) {
    add_value(
        app, name, value, [&](std::string const& t) { path = t; }, help);
}

void add_path(CLI::App& app, std::string const& name, std::string const& value,
                       std::optional<std::filesystem::path>& path, std::string const& help) {
    add_value(
        app, name, value, [&](std::string const& t) { path = t; }, help);
}

CLI::Option* add_views(CLI::App& app, std::vector<std::filesystem::path>& views) {
    return app
        .add_option_function<std::vector<std::string>>(
            "VIEW.json", [&](std::vector<std::string> const& given) { views.assign(given.begin(), given.end()); },
            "view files, JSON")
        ->required()
        ->type_name("FILE");
}

void add_scene_index(CLI::App& app, std::optional<int>& index) {
    add_value(
        app, "--scene-index", "N",
        [&index](std::string const& t) { index = static_cast<int>(parse_integer("--scene-index", t, 0, 1'000'000)); },
        "which of the file's scenes; the file's default unless given");
}

void add_overrides(CLI::App& app, std::vector<Override>& overrides) {
    add_value(
        app, "--set", "NAME=VALUE", [&](std::string const& t) { overrides.push_back(parse_override("--set", t)); },
        "a setting, in place of the file's; may be repeated")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_device_options(CLI::App& app, DrawOptions& options) {
    add_value(
        app, "--device", "N",
        [&](std::string const& t) { options.device = static_cast<int>(parse_integer("--device", t, 0, 63)); },
        "device by its number in `alpenglow devices`");
    app.add_flag("--validate", options.validate, "check every Vulkan call; slow");
}

} // namespace alpenglow
