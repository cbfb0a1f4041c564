#include "image/webp.h"

#include "core/error.h"

#include <webp/decode.h>

#include <cstdint>
#include <cstring>

namespace alpenglow {

namespace {

std::uint8_t const* data_of(std::span<std::byte const> bytes) {
    return reinterpret_cast<std::uint8_t const*>(bytes.data());
}

[[noreturn]] void fail(char const* reason) {
    throw Error(ErrorKind::bad_input, std::string("picture can't be decoded: ") + reason);
}

} // namespace

bool is_webp(std::span<std::byte const> bytes) {
    return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
           std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

PictureHeader read_webp_header(std::span<std::byte const> bytes) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(data_of(bytes), bytes.size(), &features) != VP8_STATUS_OK) fail("broken WebP header");
    if (features.has_animation) fail("it is an animation");
    return {{static_cast<std::uint32_t>(features.width), static_cast<std::uint32_t>(features.height)},
            features.has_alpha ? 4 : 3,
            8};
}

ByteImage decode_webp(std::span<std::byte const> bytes) {
    ByteImage image(read_webp_header(bytes).extent);
    int const stride = static_cast<int>(image.extent.width) * 4;
    if (!WebPDecodeRGBAInto(data_of(bytes), bytes.size(), image.rgba.data(), image.rgba.size(), stride))
        fail("broken WebP");
    return image;
}

} // namespace alpenglow
