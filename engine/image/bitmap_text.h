#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace alpenglow {

/// A small built-in font for captions: printable ASCII; anything else is drawn as '?'. One line, no wrapping.
/// `scale` is the size of the font's pixel; a line is 12 * scale pixels high.
constexpr int TEXT_LINE_HEIGHT = 12;

/// [pixels]
int text_width(std::string_view text, int scale);
/// `text`, or its beginning with ".." behind it, so that it is at most `width` pixels wide.
std::string fit_text(std::string_view text, int scale, int width);
/// Draws with the left top at x, y; what falls outside of the picture is left out. `color` is 0xRRGGBB.
void draw_text(ByteImage& picture, int x, int y, std::string_view text, std::uint32_t color, int scale);

} // namespace alpenglow
