#pragma once

#include "image/image.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace alpenglow {

/// Where the frames of a contact sheet stand.
struct ContactSheetLayout {
    std::uint32_t columns = 0, rows = 0;
    Extent cell;               ///< of a frame, without its caption
    std::uint32_t border = 0;  ///< [pixels] around and between the cells
    std::uint32_t caption = 0; ///< [pixels] height below each frame
    Extent sheet;
};

/// For `frames` pictures of one extent: as many columns as bring the sheet closest to 16:10, at most `width` pixels
/// wide; frames are never enlarged.
ContactSheetLayout lay_out_contact_sheet(std::size_t frames, Extent frame, std::uint32_t width);

/// Frames of a flight in one picture, row by row, each with a line of text below it, on dark neutral ground. Frames are
/// made smaller as they come, so only the sheet is kept in memory.
class ContactSheet {
public:
    /// For `frames` pictures of about the extent `frame`. Throws Error(bad_input) where either is nothing.
    ContactSheet(std::size_t frames, Extent frame, std::uint32_t width = 2400);

    /// The next frame; one of another shape keeps its proportions. Call it at most `frames` times.
    void add(ByteImage const& picture, std::string_view caption);

    ContactSheetLayout const& layout() const { return layout_; }
    ByteImage const& picture() const { return sheet_; }

private:
    ContactSheetLayout layout_;
    ByteImage sheet_;
    std::size_t capacity_;
    std::size_t added_ = 0;
};

} // namespace alpenglow
