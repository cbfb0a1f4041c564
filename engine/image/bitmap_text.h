#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace alpenglow {

/// A small built-in font for captions: printable ASCII; anything else is drawn as '?'. One line, no wrapping.
/// `scale` is the size of the font's pixel; a line is 12 * scale pixels high.
constexpr int TEXT_LINE_HEIGHT = 12;

/// [pixels]
int text_width(std::string_view text, int scale);
/// `text`, or its beginning with ".." behind it, so that it is at most `width` pixels wide.
std::string fit_text(std::string_view text, int scale, int width);
/// `text` in lines of at most `width` pixels, broken between words, and within one where it is longer than a line.
std::vector<std::string> wrap_text(std::string_view text, int scale, int width);
/// From left and top up to right and bottom, which are not painted; what falls outside of the picture is left out.
void fill_rectangle(ByteImage& picture, int left, int top, int right, int bottom, std::uint32_t color);
/// Draws with the left top at x, y; what falls outside of the picture is left out. `color` is 0xRRGGBB.
void draw_text(ByteImage& picture, int x, int y, std::string_view text, std::uint32_t color, int scale);

} // namespace alpenglow
