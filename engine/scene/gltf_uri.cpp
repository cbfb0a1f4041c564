#include "scene/gltf_uri.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace alpenglow::gltf {

namespace fs = std::filesystem;

namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string percent_decoded(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        bool const escape =
            text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0;
        result += escape ? static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2])) : text[i];
        if (escape) i += 2;
    }
    return result;
}

/// RFC 4648, section 4; -1 for what is not in the alphabet.
std::array<signed char, 256> make_base64_values() {
    std::array<signed char, 256> values;
    values.fill(-1);
    std::string_view const alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        values[static_cast<unsigned char>(alphabet[i])] = static_cast<signed char>(i);
    return values;
}

DataUri decode_base64(std::string_view text) {
    static std::array<signed char, 256> const values = make_base64_values();
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    DataUri data;
    data.bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (char const c : text) {
        int const value = values[static_cast<unsigned char>(c)];
        if (value < 0) return {};
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        if ((count += 6) >= 8) data.bytes.push_back(static_cast<std::byte>(bits >> (count -= 8)));
    }
    data.valid = text.size() % 4 != 1;
    return data;
}

/// A scheme is a letter and then letters, digits, "+", "-" or "." up to a colon (RFC 3986, section 3.1); this takes in
/// drives.
bool has_scheme(std::string_view uri) {
    std::size_t const colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0 || !std::isalpha(static_cast<unsigned char>(uri[0])))
        return false;
    return std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon),
                       [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; });
}

bool is_inside(fs::path const& path, fs::path const& folder) {
    std::error_code error;
    fs::path const real_folder = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) return false;
    fs::path const real_path = fs::weakly_canonical(path, error);
    if (error) return false;
    auto const [end, ignored] =
        std::mismatch(real_folder.begin(), real_folder.end(), real_path.begin(), real_path.end());
    return end == real_folder.end();
}

} // namespace

std::optional<DataUri> parse_data_uri(std::string_view uri) {
    if (!uri.starts_with("data:")) return {};
    std::size_t const comma = uri.find(',');
    if (comma == std::string_view::npos) return DataUri{};
    std::string_view const head = uri.substr(0, comma), body = uri.substr(comma + 1);
    if (head.find(";;") != std::string_view::npos) return DataUri{};
    if (head.ends_with(";base64")) return decode_base64(body);
    std::string const decoded = percent_decoded(body);
    auto const* const first = reinterpret_cast<std::byte const*>(decoded.data());
    return DataUri{true, {first, first + decoded.size()}};
}

std::string_view data_uri_type(std::string_view uri) {
    if (!uri.starts_with("data:")) return {};
    uri.remove_prefix(5);
    return uri.substr(0, uri.find_first_of(";,"));
}

FileUri resolve_file_uri(std::string_view uri, fs::path const& folder) {
    if (uri.starts_with(':')) return {{}, "has an empty scheme", true};
    if (has_scheme(uri)) return {{}, "has a scheme; only data: and files beside the scene are read"};
    std::string const name = percent_decoded(uri);
    if (name.empty()) return {{}, "is empty"};
    if (has_scheme(name)) return {{}, "has a scheme; only data: and files beside the scene are read"};
    if (name.find('\0') != std::string::npos) return {{}, "holds a NUL"};
    if (name.find('\\') != std::string::npos) return {{}, "holds a backslash"};
    fs::path const relative(name);
    if (relative.is_absolute()) return {{}, "is an absolute path; only files beside the scene are read"};
    if (std::ranges::any_of(relative, [](fs::path const& part) { return part == ".."; })) {
        return {{}, "goes up with \"..\"; only files beside the scene are read"};
    }
    fs::path const path = folder / relative;
    if (!is_inside(path, folder)) return {{}, "leaves the scene's folder through a link"};
    return {path, {}};
}

} // namespace alpenglow::gltf
