#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace alpenglow::test {

/// Damages good files: bytes, chunks of a .glb, values of JSON. The same seed gives the same damage on every machine,
/// which the standard library's distributions don't promise.
class Mutator {
public:
    explicit Mutator(std::uint32_t seed) : random_(seed) {}

    /// Flips, replaces, inserts, removes or doubles a few stretches of bytes.
    std::string bytes(std::string text);
    /// Changes one to three values of a JSON text, which stays JSON.
    std::string json(std::string const& text);
    /// Changes a .glb's header, its JSON, or the order and lengths of its chunks.
    std::string glb(std::string const& file);

    std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }

private:
    void damage_value(nlohmann::json& value);
    void damage_array(nlohmann::json& array);
    nlohmann::json odd_value();

    std::mt19937 random_;
};

namespace detail {

inline void collect(nlohmann::json& value, std::vector<nlohmann::json*>& values) {
    values.push_back(&value);
    if (!value.is_structured()) return;
    for (nlohmann::json& child : value) collect(child, values);
}

inline std::string word(std::uint32_t value) { return {reinterpret_cast<char const*>(&value), 4}; }

inline std::uint32_t word_at(std::string const& file, std::size_t offset) {
    std::uint32_t value = 0;
    if (offset + 4 <= file.size()) std::memcpy(&value, file.data() + offset, 4);
    return value;
}

} // namespace detail

inline std::string Mutator::bytes(std::string text) {
    for (std::size_t n = 1 + below(4); n > 0; --n) {
        std::size_t const at = below(text.size()), length = 1 + below(8);
        switch (below(6)) {
        case 0: if (!text.empty()) text[at] = static_cast<char>(text[at] ^ (1 << below(8))); break;
        case 1: if (!text.empty()) text[at] = static_cast<char>(below(256)); break;
        case 2: text.insert(at, length, static_cast<char>(below(256))); break;
        case 3: text.erase(std::min(at, text.size()), length); break;
        case 4: text.insert(at, text.substr(below(text.size()), length * 4)); break;
        default: text.resize(text.size() - below(text.size())); break;
        }
    }
    return text;
}

inline nlohmann::json Mutator::odd_value() {
    switch (below(12)) {
    case 0: return nullptr;
    case 1: return below(2) == 0;
    case 2: return nlohmann::json::array();
    case 3: return nlohmann::json::object();
    case 4: return std::string(below(40), 'x');
    case 5: return -1;
    case 6: return below(8);
    case 7: return std::uint64_t{1} << below(64);
    case 8: return (std::uint64_t{1} << below(64)) - 1;
    case 9: return 0.5 * static_cast<double>(below(16));
    case 10: return below(2) == 0 ? 1e308 : -1e-308;
    default: return "../" + std::string(below(4), '/') + "%00";
    }
}

inline void Mutator::damage_array(nlohmann::json& array) {
    std::size_t const at = below(array.size());
    switch (below(4)) {
    case 0: array.erase(at); break;
    case 1: array.push_back(nlohmann::json(array[at])); break;
    case 2: std::swap(array[at], array[below(array.size())]); break;
    default: for (int i = 0; i < 40; ++i) array.push_back(nlohmann::json(array[at])); break;
    }
}

inline void Mutator::damage_value(nlohmann::json& value) {
    if (value.is_number() && below(2) == 0) {
        double const number = value.get<double>();
        std::array<double, 6> const near{number + 1, number - 1, -number, 2 * number, number / 2, number * 65536};
        double const changed = near[below(near.size())];
        if (changed == static_cast<double>(static_cast<std::int64_t>(changed)))
            value = static_cast<std::int64_t>(changed);
        else
            value = changed;
    } else if (value.is_array() && !value.empty() && below(2) == 0) {
        damage_array(value);
    } else if (value.is_object() && !value.empty() && below(2) == 0) {
        auto member = value.begin();
        std::advance(member, static_cast<std::ptrdiff_t>(below(value.size())));
        value.erase(member);
    } else {
        value = odd_value();
    }
}

inline std::string Mutator::json(std::string const& text) {
    nlohmann::json document = nlohmann::json::parse(text);
    for (std::size_t n = 1 + below(3); n > 0; --n) {
        std::vector<nlohmann::json*> values;
        detail::collect(document, values);
        damage_value(*values[below(values.size())]);
    }
    return document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

inline std::string Mutator::glb(std::string const& file) {
    std::size_t const json_size = detail::word_at(file, 12);
    std::string const text = file.substr(20, json_size), rest = file.substr(20 + json_size);
    auto const assembled = [&](std::string const& body) {
        auto const size = static_cast<std::uint32_t>(12 + body.size());
        return "glTF" + detail::word(2) + detail::word(size) + body;
    };
    auto const chunk = [](std::string bytes) {
        bytes.resize((bytes.size() + 3) / 4 * 4, ' ');
        return detail::word(static_cast<std::uint32_t>(bytes.size())) + "JSON" + bytes;
    };
    switch (below(6)) {
    case 0: return assembled(chunk(json(text)) + rest);
    case 1: return assembled(chunk(text) + bytes(rest));
    case 2: return assembled(rest + chunk(text));
    case 3: return assembled(chunk(text) + rest + rest);
    case 4: return file.substr(0, below(file.size()));
    default: break;
    }
    // A word of the header or of the first chunk's: magic, version, length, chunk's length, chunk's type.
    std::string bad = file;
    std::uint32_t const odd = std::uint32_t{1} << below(32);
    std::memcpy(bad.data() + 4 * below(5), &odd, 4);
    return bad;
}

} // namespace alpenglow::test
