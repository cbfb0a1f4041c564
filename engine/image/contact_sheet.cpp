#include "image/contact_sheet.h"

#include "core/error.h"
#include "image/bitmap_text.h"
#include "image/resample.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace alpenglow {

namespace {

constexpr std::uint8_t GROUND = 24; // sRGB grey
constexpr std::uint32_t TEXT_COLOR = 0xd0d0d0;
constexpr std::uint32_t BORDER = 12; // [pixels]
constexpr double WANTED_ASPECT = 1.6;
constexpr std::uint32_t WIDE_CELL = 240; // [pixels] room for some 25 letters of double size

int text_scale(ContactSheetLayout const& layout) { return layout.cell.width >= WIDE_CELL ? 2 : 1; }

std::uint32_t scaled_side(std::uint32_t side, std::uint32_t numerator, std::uint32_t denominator) {
    return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(std::lround(double(side) * numerator / denominator)));
}

ContactSheetLayout with_columns(std::uint32_t columns, std::size_t frames, Extent frame, std::uint32_t width) {
    ContactSheetLayout layout;
    layout.columns = columns;
    layout.rows = static_cast<std::uint32_t>((frames + columns - 1) / columns);
    layout.border = BORDER;
    std::uint32_t const borders = BORDER * (columns + 1);
    layout.cell.width = std::clamp<std::uint32_t>(width > borders ? (width - borders) / columns : 1, 1, frame.width);
    layout.cell.height = scaled_side(frame.height, layout.cell.width, frame.width);
    layout.caption = static_cast<std::uint32_t>(TEXT_LINE_HEIGHT * text_scale(layout)) + 4;
    layout.sheet.width = borders + columns * layout.cell.width;
    layout.sheet.height = BORDER + layout.rows * (layout.cell.height + layout.caption + BORDER);
    return layout;
}

/// How far the sheet is from the wanted shape; empty cells count against it too, weakly.
double badness(ContactSheetLayout const& layout, std::size_t frames) {
    double const aspect = static_cast<double>(layout.sheet.width) / layout.sheet.height;
    double const empty = 1 - static_cast<double>(frames) / (double(layout.columns) * layout.rows);
    return std::abs(std::log(aspect / WANTED_ASPECT)) + 0.5 * empty;
}

Extent fitted(Extent picture, Extent cell) {
    bool const wide = std::uint64_t{picture.width} * cell.height >= std::uint64_t{cell.width} * picture.height;
    std::uint32_t const width =
        wide ? cell.width : std::min(cell.width, scaled_side(picture.width, cell.height, picture.height));
    std::uint32_t const height =
        wide ? std::min(cell.height, scaled_side(picture.height, cell.width, picture.width)) : cell.height;
    return {width, height};
}

} // namespace

ContactSheetLayout lay_out_contact_sheet(std::size_t frames, Extent frame, std::uint32_t width) {
    if (frames == 0 || frame.pixels() == 0)
        throw Error(ErrorKind::bad_input, "a contact sheet needs at least one frame");
    ContactSheetLayout best;
    double least = std::numeric_limits<double>::infinity();
    auto const most =
        static_cast<std::uint32_t>(std::min<std::size_t>(frames, std::max<std::uint32_t>(width / (2 * BORDER), 1)));
    for (std::uint32_t columns = 1; columns <= most; ++columns) {
        ContactSheetLayout const layout = with_columns(columns, frames, frame, width);
        if (double const b = badness(layout, frames); b < least) best = layout, least = b;
    }
    return best;
}

ContactSheet::ContactSheet(std::size_t frames, Extent frame, std::uint32_t width)
    : layout_(lay_out_contact_sheet(frames, frame, width)), sheet_(layout_.sheet), capacity_(frames) {
    for (std::size_t i = 0; i < sheet_.rgba.size(); ++i) sheet_.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : GROUND;
}

void ContactSheet::add(ByteImage const& picture, std::string_view caption) {
    assert(added_ < capacity_);
    auto const column = static_cast<std::uint32_t>(added_ % layout_.columns),
               row = static_cast<std::uint32_t>(added_ / layout_.columns);
    ++added_;
    std::uint32_t const left = layout_.border + column * (layout_.cell.width + layout_.border);
    std::uint32_t const top = layout_.border + row * (layout_.cell.height + layout_.caption + layout_.border);

    ByteImage const small = resample(picture, fitted(picture.extent, layout_.cell));
    std::uint32_t const inset_x = (layout_.cell.width - small.extent.width) / 2,
                        inset_y = (layout_.cell.height - small.extent.height) / 2;
    for (std::uint32_t y = 0; y < small.extent.height; ++y) {
        std::copy_n(small.at(0, y), std::size_t{small.extent.width} * 4, sheet_.at(left + inset_x, top + inset_y + y));
    }
    int const scale = text_scale(layout_);
    draw_text(sheet_, static_cast<int>(left), static_cast<int>(top + layout_.cell.height + 6),
              fit_text(caption, scale, static_cast<int>(layout_.cell.width)), TEXT_COLOR, scale);
}

} // namespace alpenglow
