#pragma once

#include "image/codec.h"

namespace alpenglow {

/// By its first bytes.
bool is_webp(std::span<std::byte const> bytes);

/// As read_picture_header and decode_picture. An animation is no picture. Throws Error(bad_input).
PictureHeader read_webp_header(std::span<std::byte const> bytes);
ByteImage decode_webp(std::span<std::byte const> bytes);

} // namespace alpenglow
