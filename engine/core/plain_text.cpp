#include "core/plain_text.h"

#include <algorithm>
#include <cstdint>

namespace alpenglow {

namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t length = 0; ///< [bytes]; 0: not UTF-8
};

/// The first character of a text that is not empty (RFC 3629, section 4).
Character first_character(std::string_view text) {
    auto const byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return {byte(0), 1};
    std::size_t const length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return {};
    std::uint32_t code = byte(0) & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    bool const longer_than_needed = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    bool const surrogate = code >= 0xD800 && code <= 0xDFFF;
    return longer_than_needed || surrogate || code > 0x10FFFF ? Character{} : Character{code, length};
}

bool is_hidden(std::uint32_t code) {
    bool const control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    bool const separator = code == 0x2028 || code == 0x2029;
    bool const direction = code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
                           (code >= 0x2066 && code <= 0x2069);
    return control || separator || direction;
}

} // namespace

std::string plain_text(std::string_view text, std::size_t longest) {
    std::string line;
    line.reserve(std::min(text.size(), longest));
    while (!text.empty()) {
        Character const character = first_character(text);
        std::size_t const length = std::max<std::size_t>(character.length, 1);
        if (line.size() + length > longest) return line + "…";
        if (character.length == 0)
            line += '?';
        else if (is_hidden(character.code))
            line += ' ';
        else
            line += text.substr(0, length);
        text.remove_prefix(length);
    }
    return line;
}

} // namespace alpenglow
