#include "scene/gltf_json.h"

#include <cmath>
#include <fmt/format.h>

namespace alpenglow::gltf {

namespace {

constexpr int no_index = -1;

} // namespace

JsonObject::JsonObject(nlohmann::json const& value, std::string pointer, Report const& report)
    : value_(value), pointer_(std::move(pointer)), report_(report) {
    if (!value_.is_object()) report_.fail(pointer_, "must be an object");
}

std::vector<std::string> JsonObject::names() const {
    std::vector<std::string> result;
    for (auto const& [name, member] : value_.items()) result.push_back(name);
    return result;
}

void JsonObject::fail(std::string const& name, std::string const& reason) const {
    report_.fail(pointer_ + "/" + name, reason);
}

void JsonObject::require(std::string const& name) const {
    if (!has(name)) fail(name, "is missing");
}

std::optional<JsonObject> JsonObject::find(std::string const& name) const {
    auto const member = value_.find(name);
    if (member == value_.end()) return {};
    return JsonObject(*member, pointer_ + "/" + name, report_);
}

std::optional<JsonObject> JsonObject::extension(std::string const& name) const {
    std::optional<JsonObject> const extensions = find("extensions");
    return extensions ? extensions->find(name) : std::nullopt;
}

std::vector<JsonObject> JsonObject::objects(std::string const& name) const {
    auto const member = value_.find(name);
    if (member == value_.end()) return {};
    if (!member->is_array()) fail(name, "must be an array");
    std::vector<JsonObject> result;
    result.reserve(member->size());
    for (std::size_t i = 0; i < member->size(); ++i)
        result.emplace_back((*member)[i], fmt::format("{}/{}/{}", pointer_, name, i), report_);
    return result;
}

double JsonObject::checked_number(nlohmann::json const& value, std::string const& name, double lowest,
                                  double highest) const {
    if (!value.is_number()) fail(name, "must be a number");
    double const number = value.get<double>();
    if (!(number >= lowest && number <= highest))
        fail(name, fmt::format("is {}, and must be from {} to {}", number, lowest, highest));
    return number;
}

double JsonObject::number(std::string const& name, double fallback, double lowest, double highest) const {
    auto const member = value_.find(name);
    return member == value_.end() ? fallback : checked_number(*member, name, lowest, highest);
}

std::vector<double> JsonObject::numbers(std::string const& name, std::vector<double> fallback, double lowest,
                                        double highest) const {
    auto const member = value_.find(name);
    if (member == value_.end()) return fallback;
    if (!member->is_array() || (!fallback.empty() && member->size() != fallback.size()))
        fail(name, fallback.empty() ? "must be an array of numbers"
                                    : fmt::format("must be an array of {} numbers", fallback.size()));
    std::vector<double> result;
    for (std::size_t i = 0; i < member->size(); ++i)
        result.push_back(checked_number((*member)[i], fmt::format("{}/{}", name, i), lowest, highest));
    return result;
}

std::uint64_t JsonObject::whole(std::string const& name, std::uint64_t fallback, std::uint64_t lowest,
                                std::uint64_t highest) const {
    auto const member = value_.find(name);
    if (member == value_.end()) return fallback;
    double const number = checked_number(*member, name, static_cast<double>(lowest), static_cast<double>(highest));
    if (number != std::floor(number)) fail(name, "must be an integer");
    return static_cast<std::uint64_t>(number);
}

int JsonObject::index(std::string const& name, std::size_t count) const {
    if (!has(name)) return no_index;
    if (count == 0) fail(name, "is an index, but there is nothing to point to");
    return static_cast<int>(whole(name, 0, 0, count - 1));
}

std::vector<int> JsonObject::indices(std::string const& name, std::size_t count) const {
    std::vector<int> result;
    if (!has(name)) return result;
    for (double const number : numbers(name, {}, 0, static_cast<double>(count) - 1)) {
        if (number != std::floor(number)) fail(name, "must hold integers");
        result.push_back(static_cast<int>(number));
    }
    return result;
}

std::string JsonObject::text(std::string const& name, std::string const& fallback) const {
    auto const member = value_.find(name);
    if (member == value_.end()) return fallback;
    if (!member->is_string()) fail(name, "must be a text");
    return member->get<std::string>();
}

bool JsonObject::flag(std::string const& name) const {
    auto const member = value_.find(name);
    if (member == value_.end()) return false;
    if (!member->is_boolean()) fail(name, "must be true or false");
    return member->get<bool>();
}

} // namespace alpenglow::gltf
