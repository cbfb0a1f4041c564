#pragma once

#include "image/image.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace alpenglow {

/// PNG, 8 bits RGBA (RGB where every alpha is 255), lossless.
std::vector<std::byte> encode_png(ByteImage const& image);
/// JPEG; alpha is dropped. `quality` 1 to 100; above 90 colours keep the full resolution.
std::vector<std::byte> encode_jpeg(ByteImage const& image, int quality);
void write_png(std::filesystem::path const& path, ByteImage const& image);

/// What the header of a PNG, JPEG or WebP says, without decoding. Throws Error(bad_input) where it is none of them.
struct PictureHeader {
    Extent extent;
    int channels = 0;
    int bits = 8;
};
PictureHeader read_picture_header(std::span<std::byte const> bytes);

/// Decodes a PNG, JPEG or WebP to 8-bit RGBA as stored (no colour conversion). Throws Error(bad_input).
ByteImage decode_picture(std::span<std::byte const> bytes);
/// The same with 16 bits a channel, for a PNG whose header says so. Throws Error(bad_input).
DeepImage decode_deep_picture(std::span<std::byte const> bytes);
ByteImage read_picture(std::filesystem::path const& path);

} // namespace alpenglow
