#include "scene/json_reader.h"

#include "core/error.h"
#include "core/files.h"
#include "core/suggestion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace alpenglow::json {

namespace {

constexpr std::uint64_t LARGEST_FILE = std::uint64_t{4} << 20; // [bytes]
constexpr int DEEPEST = 16;

/// Texts from files are quoted in messages up to this length.
constexpr std::size_t LONGEST_QUOTE = 60;

/// The value as the file has it, in ASCII and cut short.
std::string quote(nlohmann::json const& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list";
    std::string text = value.dump(-1, ' ', true);
    return text.size() > LONGEST_QUOTE ? text.substr(0, LONGEST_QUOTE) + "…" : text;
}

/// What nlohmann says, without its prefix and without the bytes that it read last.
std::string parser_message(std::string text) {
    if (std::size_t const bracket = text.find("] "); bracket != std::string::npos) text.erase(0, bracket + 2);
    if (std::size_t const bytes = text.find("; last read"); bytes != std::string::npos) text.erase(bytes);
    return text.substr(0, 200);
}

std::string location(std::string const& file, std::string const& pointer) {
    return pointer.empty() ? file : fmt::format("{} at {}", file, pointer);
}

/// Watches the parser for what a finished tree no longer shows: duplicate keys, and nesting before it costs anything.
class Guard {
public:
    explicit Guard(std::string file) : file_(std::move(file)) {}

    bool operator()(int depth, nlohmann::json::parse_event_t event, nlohmann::json const& parsed) {
        using Event = nlohmann::json::parse_event_t;
        if (depth > DEEPEST) {
            throw Error(ErrorKind::bad_input, fmt::format("is nested more than {} levels deep", DEEPEST), file_,
                        "our files need eight");
        }
        if (event == Event::object_start) open_.emplace_back();
        if (event == Event::object_end) open_.pop_back();
        if (event == Event::key) add_key(parsed.get<std::string>());
        return true;
    }

private:
    void add_key(std::string const& key) {
        if (open_.back().insert(key).second) return;
        throw Error(ErrorKind::bad_input, fmt::format("key {} stands twice in one object", quote(key)), file_,
                    "remove one of the two");
    }

    std::string file_;
    std::vector<std::set<std::string>> open_;
};

nlohmann::json parse(std::filesystem::path const& path) {
    std::string const text = read_text_file(path, LARGEST_FILE);
    try {
        return nlohmann::json::parse(text, Guard(path.string()));
    } catch (nlohmann::json::exception const& error) {
        throw Error(ErrorKind::bad_input, "is not JSON: " + parser_message(error.what()), path.string(),
                    "comments, trailing commas, NaN, Infinity and numbers beyond 1e308 are no JSON");
    }
}

std::string range_text(NumberKey const& key) {
    return fmt::format("{} {} and at most {}", key.above_smallest ? "more than" : "at least", key.smallest,
                       key.largest);
}

} // namespace

void Value::refuse(std::string const& what, std::string const& advice) const {
    throw Error(ErrorKind::bad_input, what, location(file_, pointer_), advice);
}

std::string Value::quoted() const { return quote(*json_); }

double Value::number(NumberKey const& key) const {
    if (!json_->is_number())
        refuse(quoted() + " is not a number", fmt::format("give {}, {}", key.help, range_text(key)));
    double const number = json_->get<double>();
    bool const high_enough = key.above_smallest ? number > key.smallest : number >= key.smallest;
    if (!std::isfinite(number) || !high_enough || number > key.largest) {
        refuse(quoted() + " is out of range", fmt::format("give {}, {}", key.help, range_text(key)));
    }
    return number;
}

std::string Value::text() const {
    if (!is_text()) refuse(quoted() + " is not a text", "put it in quotation marks");
    std::string text = json_->get<std::string>();
    if (text.find('\0') != std::string::npos) refuse("the text holds a zero byte", "remove it");
    return text;
}

bool Value::boolean() const {
    if (!json_->is_boolean()) refuse(quoted() + " is not a switch", "give true or false");
    return json_->get<bool>();
}

glm::dvec3 Value::triple(NumberKey const& key) const {
    if (!json_->is_array() || json_->size() != 3)
        refuse(quoted() + " is not a list of three numbers", "give red, green and blue");
    std::vector<Value> const channels = list();
    return {channels[0].number(key), channels[1].number(key), channels[2].number(key)};
}

std::vector<Value> Value::list() const {
    if (!json_->is_array()) refuse(quoted() + " is not a list", "put it in square brackets");
    std::vector<Value> values;
    for (nlohmann::json const& value : *json_) {
        values.emplace_back(value, file_, fmt::format("{}/{}", pointer_, values.size()));
    }
    return values;
}

Object Value::object(std::vector<std::string_view> known) const {
    if (!json_->is_object())
        refuse(quoted() + " is not an object", fmt::format("its keys are {}", fmt::join(known, ", ")));
    for (auto const& [key, value] : json_->items()) {
        if (std::ranges::find(known, std::string_view(key)) != known.end()) continue;
        std::string advice = suggestion(key, known);
        if (advice.empty()) advice = fmt::format("the keys here are {}", fmt::join(known, ", "));
        refuse("unknown key " + quote(key), advice);
    }
    return {*this, std::move(known)};
}

Value Value::child(std::string_view key) const {
    return {json_->at(std::string(key)), file_, fmt::format("{}/{}", pointer_, key)};
}

bool Object::has(std::string_view key) const {
    assert(std::ranges::find(known_, key) != known_.end());
    return self_.json().contains(std::string(key));
}

Value Object::at(std::string_view key) const {
    if (!has(key)) self_.refuse(fmt::format("has no \"{}\"", key), "add it");
    return self_.child(key);
}

double Object::number(NumberKey const& key) const {
    if (key.fallback && !has(key.name)) return *key.fallback;
    return at(key.name).number(key);
}

File::File(std::filesystem::path const& path) : path_(path), json_(parse(path)) {}

} // namespace alpenglow::json
