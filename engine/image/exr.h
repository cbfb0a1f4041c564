#pragma once

#include "image/image.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace alpenglow {

/// OpenEXR, scan lines, ZIP, 32-bit float, lossless; Rec.709 chromaticities. Channels R, G, B, and A where some alpha
/// is not 1. Throws Error(bad_input) for a picture without pixels.
std::vector<std::byte> encode_exr(FloatImage const& image);
void write_exr(std::filesystem::path const& path, FloatImage const& image);

/// The first part's data window. Channels R, G, B and, where present, A (else 1), each half or float, in files of scan
/// lines or tiles; other channels are left out. Throws Error(bad_input) where one of R, G, B is missing, subsampled or
/// of integers, where the picture is larger than 32768 along a side or 2^26 pixels, and where the file is broken or cut
/// short.
FloatImage decode_exr(std::span<std::byte const> bytes);
FloatImage read_exr(std::filesystem::path const& path);

} // namespace alpenglow
