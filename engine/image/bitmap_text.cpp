#include "image/bitmap_text.h"

#include <algorithm>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace alpenglow {

namespace {

/// stb_easy_font's vertex: four to a rectangle, clockwise from the left top.
struct Corner {
    float x, y, z;
    std::uint8_t color[4];
};
using Rectangle = Corner[4];

/// stb_easy_font's tables hold nothing but 32 to 126, and it does not check.
std::string printable(std::string_view text) {
    std::string result(text);
    std::replace_if(
        result.begin(), result.end(), [](char c) { return c < 32 || c > 126; }, '?');
    return result;
}

} // namespace

int text_width(std::string_view text, int scale) {
    std::string line = printable(text);
    return scale * stb_easy_font_width(line.data());
}

std::string fit_text(std::string_view text, int scale, int width) {
    if (text_width(text, scale) <= width) return std::string(text);
    while (!text.empty()) {
        text.remove_suffix(1);
        std::string shortened = std::string(text) + "..";
        if (text_width(shortened, scale) <= width) return shortened;
    }
    return {};
}

std::vector<std::string> wrap_text(std::string_view text, int scale, int width) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        std::size_t count = text.size();
        while (count > 1 && text_width(text.substr(0, count), scale) > width) --count;
        std::size_t const space = text.rfind(' ', count);
        bool const between_words = count < text.size() && space != std::string_view::npos && space > 0;
        if (between_words) count = space;
        lines.emplace_back(text.substr(0, count));
        text.remove_prefix(between_words ? count + 1 : count);
    }
    return lines;
}

void fill_rectangle(ByteImage& picture, int left, int top, int right, int bottom, std::uint32_t color) {
    int const width = static_cast<int>(picture.extent.width), height = static_cast<int>(picture.extent.height);
    for (int y = std::max(top, 0); y < std::min(bottom, height); ++y) {
        for (int x = std::max(left, 0); x < std::min(right, width); ++x) {
            std::uint8_t* const pixel = picture.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
            for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(color >> (16 - 8 * c));
            pixel[3] = 255;
        }
    }
}

void draw_text(ByteImage& picture, int x, int y, std::string_view text, std::uint32_t color, int scale) {
    constexpr std::size_t most_rectangles = 24; // of one character
    std::string line = printable(text);
    std::vector<Rectangle> rectangles(most_rectangles * line.size() + 1);
    int const count = stb_easy_font_print(0, 0, line.data(), nullptr, rectangles.data(),
                                          static_cast<int>(rectangles.size() * sizeof(Rectangle)));
    for (int i = 0; i < count; ++i) {
        Corner const &first = rectangles[static_cast<std::size_t>(i)][0],
                     &last = rectangles[static_cast<std::size_t>(i)][2];
        fill_rectangle(picture, x + scale * static_cast<int>(first.x), y + scale * static_cast<int>(first.y),
             x + scale * static_cast<int>(last.x), y + scale * static_cast<int>(last.y), color);
    }
}

} // namespace alpenglow
