#pragma once

#include "scene/gltf_report.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace alpenglow::gltf {

/// An object of a glTF file's JSON that is read member by member. Every read checks type and range and throws
/// Error(bad_input) with the member's JSON pointer. It keeps references to the JSON and the report.
class JsonObject {
public:
    JsonObject(nlohmann::json const& value, std::string pointer, Report const& report);

    std::string const& pointer() const { return pointer_; }
    bool has(std::string const& name) const { return value_.contains(name); }
    std::vector<std::string> names() const;
    /// Nothing where the member is absent.
    std::optional<JsonObject> find(std::string const& name) const;
    /// Member `name` of "extensions".
    std::optional<JsonObject> extension(std::string const& name) const;
    /// The objects of an array; none where it is absent.
    std::vector<JsonObject> objects(std::string const& name) const;

    double number(std::string const& name, double fallback, double lowest = -std::numeric_limits<float>::max(),
                  double highest = std::numeric_limits<float>::max()) const;
    /// `fallback.size()` numbers; any count, where `fallback` is empty.
    std::vector<double> numbers(std::string const& name, std::vector<double> fallback,
                                double lowest = -std::numeric_limits<float>::max(),
                                double highest = std::numeric_limits<float>::max()) const;
    std::uint64_t whole(std::string const& name, std::uint64_t fallback, std::uint64_t lowest,
                        std::uint64_t highest) const;
    /// An index below `count`; no_index (-1) where the member is absent.
    int index(std::string const& name, std::size_t count) const;
    std::vector<int> indices(std::string const& name, std::size_t count) const;
    std::string text(std::string const& name, std::string const& fallback) const;
    bool flag(std::string const& name) const;

    [[noreturn]] void fail(std::string const& name, std::string const& reason) const;
    void require(std::string const& name) const;

private:
    double checked_number(nlohmann::json const& value, std::string const& name, double lowest, double highest) const;

    nlohmann::json const& value_;
    std::string pointer_;
    Report const& report_;
};

} // namespace alpenglow::gltf
