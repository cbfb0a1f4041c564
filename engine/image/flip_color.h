#pragma once

#include <array>

/// The colours of FLIP, and how far apart two of them look. Sections are of Andersson, Nilsson, Akenine-Möller,
/// Oskarsson, Åström, Fairchild: "FLIP: A Difference Evaluator for Alternating Images", HPG 2020.
namespace alpenglow::flip {

using Color = std::array<float, 3>;

/// The linear opponent space in which the eye's contrast sensitivity is applied (section 4.1.1), from linear Rec.709,
/// and back. White is (100, 0, 0).
Color ycxcz_from_rgb(Color const& rgb);
Color rgb_from_ycxcz(Color const& ycxcz);

/// CIELAB with the Hunt effect: colours of little light look less colourful (section 4.1.3). From linear Rec.709.
Color hunt_lab_from_rgb(Color const& rgb);

/// The HyAB distance (Abasi, Amani Tehran, Fairchild 2020) of two Hunt-adjusted colours.
float hyab(Color const& a, Color const& b);

/// 0..1 from a HyAB distance: compressed by a power, and small differences given most of the range (section 4.1.4).
/// 1 is the distance from green to blue.
float color_error(float distance);

} // namespace alpenglow::flip
