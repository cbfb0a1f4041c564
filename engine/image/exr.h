#pragma once

#include "image/image.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
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

/// A measured picture, how sure each of its pixels is, and how it was made.
struct RadianceRecord {
    FloatImage radiance;
    std::optional<FloatImage> variance; ///< of each pixel's mean, by channel [radiance squared]; of radiance's extent
    std::map<std::string, std::string> attributes; ///< text: "command", "seed", "samples", "noise_flip", …
};

/// As encode_exr of a picture, with the channels R, G, B and, where there is a variance, variance.R, variance.G and
/// variance.B; alpha is not kept. Throws Error(bad_input) too where the extents differ, and for an attribute whose name
/// is empty, longer than 255 letters, holds a zero, or is taken by EXR for something that is not text.
std::vector<std::byte> encode_exr(RadianceRecord const& record);
void write_exr(std::filesystem::path const& path, RadianceRecord const& record);

/// As decode_exr, with the variance where the file has one, and its text attributes; those of other types are left out.
/// Throws Error(bad_input) too where only some of the variance's channels are there.
RadianceRecord decode_record(std::span<std::byte const> bytes);
RadianceRecord read_record(std::filesystem::path const& path);

} // namespace alpenglow
