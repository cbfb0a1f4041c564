#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Strict reading of our own JSON files. Every refusal is an Error(bad_input) that names the file, the place in it as a
/// JSON pointer, what is wrong and what to do.
namespace alpenglow::json {

/// A number's key in a file: the reader and the schema are both made from it.
struct NumberKey {
    std::string_view name;
    double smallest, largest;
    std::string_view help;         ///< meaning and unit
    bool above_smallest = false;   ///< `smallest` itself is refused
    std::optional<double> fallback = std::nullopt; ///< nothing: the key is required
};

class Object;

/// A value and where it stands.
class Value {
public:
    Value(nlohmann::json const& json, std::string file, std::string pointer)
        : json_(&json), file_(std::move(file)), pointer_(std::move(pointer)) {}

    [[noreturn]] void refuse(std::string const& what, std::string const& advice) const;

    nlohmann::json const& json() const { return *json_; }
    /// For messages: the value in ASCII, cut short.
    std::string quoted() const;
    bool is_text() const { return json_->is_string(); }
    /// Finite and in the key's range.
    double number(NumberKey const& key) const;
    std::string text() const;
    bool boolean() const;
    /// Three numbers in the key's range.
    glm::dvec3 triple(NumberKey const& key) const;
    std::vector<Value> list() const;
    /// Refuses every key that is not in `known`.
    Object object(std::vector<std::string_view> known) const;

private:
    friend class Object;
    Value child(std::string_view key) const;

    nlohmann::json const* json_;
    std::string file_, pointer_;
};

/// An object all of whose keys are known.
class Object {
public:
    Object(Value const& self, std::vector<std::string_view> known) : self_(self), known_(std::move(known)) {}

    Value const& self() const { return self_; }
    bool has(std::string_view key) const;
    /// `key` must be one of the known ones. Refuses the object where the key is missing.
    Value at(std::string_view key) const;
    /// The key's value, or its fallback; refuses the object where there is neither.
    double number(NumberKey const& key) const;

private:
    Value self_;
    std::vector<std::string_view> known_;
};

/// A whole file in memory. Refuses what is not JSON, duplicate keys, more than 4 MiB and more than 16 levels.
class File {
public:
    explicit File(std::filesystem::path const& path);
    Value root() const { return {json_, path_.string(), ""}; }

private:
    std::filesystem::path path_;
    nlohmann::json json_;
};

} // namespace alpenglow::json
