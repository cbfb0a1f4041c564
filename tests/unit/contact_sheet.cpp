#include "image/bitmap_text.h"
#include "image/contact_sheet.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace alpenglow;

namespace {

ByteImage uniform(Extent extent, std::uint8_t value) {
    ByteImage image(extent);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : value;
    return image;
}

int bright_pixels(ByteImage const& picture, std::uint32_t top, std::uint32_t bottom) {
    int count = 0;
    for (std::uint32_t y = top; y < bottom; ++y) {
        for (std::uint32_t x = 0; x < picture.extent.width; ++x) count += picture.at(x, y)[0] > 150;
    }
    return count;
}

} // namespace

TEST(ContactSheet, holds_every_frame_at_about_16_to_10) {
    for (std::size_t frames : {1u, 2u, 5u, 12u, 24u, 25u, 60u}) {
        ContactSheetLayout const layout = lay_out_contact_sheet(frames, {1280, 720}, 2400);
        EXPECT_GE(std::size_t{layout.columns} * layout.rows, frames);
        EXPECT_LT(std::size_t{layout.columns} * (layout.rows - 1), frames) << "an empty row";
        EXPECT_LE(layout.sheet.width, 2400u);
        EXPECT_LE(layout.cell.width, 1280u);
        double const aspect = static_cast<double>(layout.sheet.width) / layout.sheet.height;
        // A few frames of one shape can only be stacked in a few ways.
        if (frames > 9) {
            EXPECT_NEAR(std::log(aspect / 1.6), 0, std::log(1.35)) << frames << " frames: " << aspect;
        }
    }
    EXPECT_EQ(lay_out_contact_sheet(24, {1280, 720}, 2400).columns, 5u);
}

TEST(ContactSheet, frames_keep_their_proportions_and_are_never_enlarged) {
    ContactSheetLayout const small = lay_out_contact_sheet(4, {64, 36}, 2400);
    EXPECT_EQ(small.cell, (Extent{64, 36}));
    ContactSheetLayout const large = lay_out_contact_sheet(9, {3840, 2160}, 1200);
    EXPECT_NEAR(static_cast<double>(large.cell.width) / large.cell.height, 16.0 / 9, 0.02); // whole pixels
}

TEST(ContactSheet, frames_stand_in_their_cells_on_dark_ground) {
    ContactSheet sheet(4, {320, 200}, 700);
    for (int i = 0; i < 4; ++i) sheet.add(uniform({320, 200}, static_cast<std::uint8_t>(100 + 20 * i)), "");
    ContactSheetLayout const& l = sheet.layout();
    for (std::uint32_t i = 0; i < 4; ++i) {
        std::uint32_t const left = l.border + (i % l.columns) * (l.cell.width + l.border);
        std::uint32_t const top = l.border + (i / l.columns) * (l.cell.height + l.caption + l.border);
        EXPECT_EQ(sheet.picture().at(left, top)[0], 100 + 20 * i);
        EXPECT_EQ(sheet.picture().at(left + l.cell.width - 1, top + l.cell.height - 1)[1], 100 + 20 * i);
        EXPECT_LT(sheet.picture().at(left - 1, top)[0], 40);
        EXPECT_LT(sheet.picture().at(left, top + l.cell.height)[0], 40);
    }
}

TEST(ContactSheet, a_frame_of_another_shape_is_fitted_with_its_proportions) {
    ContactSheet sheet(1, {160, 90});
    sheet.add(uniform({90, 90}, 200), "");
    ContactSheetLayout const& l = sheet.layout();
    EXPECT_LT(sheet.picture().at(l.border + 30, l.border + 45)[0], 40);
    EXPECT_EQ(sheet.picture().at(l.border + 80, l.border + 45)[0], 200);
    EXPECT_LT(sheet.picture().at(l.border + 130, l.border + 45)[0], 40);
}

TEST(ContactSheet, captions_stand_below_the_frames_and_stay_in_their_cells) {
    ContactSheet sheet(1, {320, 180});
    sheet.add(uniform({320, 180}, 60), std::string(400, 'W'));
    ContactSheetLayout const& l = sheet.layout();
    EXPECT_EQ(bright_pixels(sheet.picture(), 0, l.border + l.cell.height), 0);
    EXPECT_GT(bright_pixels(sheet.picture(), l.border + l.cell.height, l.sheet.height), 200);
    for (std::uint32_t y = 0; y < l.sheet.height; ++y) {
        EXPECT_LT(sheet.picture().at(l.border + l.cell.width + 2, y)[0], 40);
    }
}

TEST(ContactSheet, nothing_is_refused) {
    EXPECT_THROW(ContactSheet(0, {4, 4}), Error);
    EXPECT_THROW(ContactSheet(4, {0, 4}), Error);
}

TEST(BitmapText, has_a_glyph_for_every_printable_character) {
    for (char c = '!'; c <= '~'; ++c) {
        ByteImage picture = uniform({32, 32}, 0);
        draw_text(picture, 4, 4, std::string(1, c), 0xffffff, 1);
        EXPECT_GT(bright_pixels(picture, 0, 32), 0) << c;
    }
}

TEST(BitmapText, draws_only_inside_and_survives_any_byte) {
    ByteImage picture = uniform({16, 16}, 0);
    draw_text(picture, -20, -5, "edge \xff\x01 \xc3\xa9", 0xffffff, 3);
    EXPECT_EQ(text_width("\xff\x01", 2), text_width("??", 2));
}

TEST(BitmapText, wrapped_lines_fit_and_lose_nothing_but_spaces_between_words) {
    std::string const text = "needs a reader of glTF 2.1 and averyverylongwordthatfitsnowhere at all";
    for (int const width : {30, 60, 100, 1000}) {
        std::string joined, unbroken;
        for (std::string const& line : wrap_text(text, 1, width)) {
            EXPECT_LE(text_width(line, 1), width) << line;
            joined += line;
        }
        std::erase(joined, ' ');
        std::ranges::copy_if(text, std::back_inserter(unbroken), [](char c) { return c != ' '; });
        EXPECT_EQ(joined, unbroken) << width;
    }
    EXPECT_EQ(wrap_text("two words", 1, text_width("two word", 1)), (std::vector<std::string>{"two", "words"}));
    EXPECT_EQ(wrap_text(text, 1, 1000), std::vector<std::string>{text});
    EXPECT_TRUE(wrap_text("", 1, 100).empty());
    EXPECT_EQ(wrap_text("ab", 1, 1), (std::vector<std::string>{"a", "b"})); // narrower than a letter: one a line
}
