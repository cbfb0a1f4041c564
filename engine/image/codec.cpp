#include "image/codec.h"

#include "core/error.h"
#include "core/files.h"
#include "image/webp.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <zlib.h>

namespace {

/// stb's own deflate is several times slower than zlib's. stb frees the result with free().
unsigned char* compress_for_stb(unsigned char* data, int size, int* compressed_size, int level) {
    uLongf length = compressBound(static_cast<uLong>(size));
    auto* const bytes = static_cast<unsigned char*>(std::malloc(length));
    if (!bytes || compress2(bytes, &length, data, static_cast<uLong>(size), level) != Z_OK) {
        std::free(bytes);
        return nullptr;
    }
    *compressed_size = static_cast<int>(length);
    return bytes;
}

/// [bytes] that stb may take at once on this thread: a picture's header says how many there can be to decode, whatever
/// the bytes behind it would unpack to.
thread_local std::size_t most_stb_bytes = std::numeric_limits<std::size_t>::max();

void* allocate_for_stb(std::size_t size) { return size <= most_stb_bytes ? std::malloc(size) : nullptr; }
void* reallocate_for_stb(void* bytes, std::size_t size) {
    return size <= most_stb_bytes ? std::realloc(bytes, size) : nullptr;
}

} // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 32768
#define STBI_MALLOC allocate_for_stb
#define STBI_REALLOC reallocate_for_stb
#define STBI_FREE std::free
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS compress_for_stb
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace alpenglow {

namespace {

stbi_uc const* data_of(std::span<std::byte const> bytes) { return reinterpret_cast<stbi_uc const*>(bytes.data()); }

int length_of(std::span<std::byte const> bytes) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw Error(ErrorKind::bad_input, "picture of more than 2 GiB");
    }
    return static_cast<int>(bytes.size());
}

[[noreturn]] void fail() {
    char const* const given = stbi_failure_reason();
    std::string const reason = given ? given : "unknown format";
    throw Error(ErrorKind::bad_input, "picture can't be decoded: " +
                                          (reason == "outofmem" ? "it unpacks to more than its header says" : reason));
}

/// Bounds what stb takes while it decodes `bytes`.
class StbMemory {
public:
    explicit StbMemory(std::span<std::byte const> bytes) {
        Extent const extent = read_picture_header(bytes).extent;
        // 16-bit RGBA, padded to JPEG's blocks of up to 32 texels, and twice that for a buffer that grows by doubling;
        // or the file's own compressed bytes, gathered the same way.
        std::size_t const texels = std::size_t{extent.width + 32} * (extent.height + 32);
        most_stb_bytes = std::max(2 * 8 * texels, 2 * bytes.size()) + fixed;
    }
    ~StbMemory() { most_stb_bytes = std::numeric_limits<std::size_t>::max(); }
    StbMemory(StbMemory const&) = delete;
    StbMemory& operator=(StbMemory const&) = delete;

private:
    static constexpr std::size_t fixed = 1 << 20; ///< stb's own tables
};

/// A progressive JPEG goes over the whole picture once for each scan; a few bytes suffice for one.
void check_scans(std::span<std::byte const> bytes) {
    constexpr int most = 256; // encoders write about ten
    constexpr std::byte marker{0xFF}, scan{0xDA};
    if (bytes.size() < 2 || bytes[0] != marker || bytes[1] != std::byte{0xD8}) return;
    int scans = 0;
    for (std::size_t i = 0; i + 1 < bytes.size(); ++i) scans += bytes[i] == marker && bytes[i + 1] == scan;
    if (scans > most)
        throw Error(ErrorKind::bad_input, "picture can't be decoded: JPEG of " + std::to_string(scans) + " scans, " +
                                              std::to_string(most) + " are read");
}

/// A Huffman table has at most 256 codes (ISO/IEC 10918-1, B.2.4.2); stb_image 2.27 writes beyond its array for more.
void check_code_tables(std::span<std::byte const> bytes) {
    constexpr std::byte marker{0xFF}, tables{0xC4};
    auto const at = [&](std::size_t i) { return std::to_integer<std::size_t>(bytes[i]); };
    if (bytes.size() < 2 || bytes[0] != marker || bytes[1] != std::byte{0xD8}) return;
    for (std::size_t i = 2; i + 4 <= bytes.size();) {
        // Between segments stand a scan's bits, in which no such marker can be, and what decoders skip.
        bool const has_length = bytes[i] == marker && at(i + 1) >= 0xC0 && (at(i + 1) < 0xD0 || at(i + 1) > 0xD9) &&
                                at(i + 1) != 0xFF;
        std::size_t const end = has_length ? i + 2 + at(i + 2) * 256 + at(i + 3) : i + 1;
        bool const holds_tables = has_length && bytes[i + 1] == tables;
        // A table that begins inside its segment is read to its own end, and what the file lacks as zeros.
        for (std::size_t table = i + 4; holds_tables && table < std::min(end, bytes.size());) {
            std::size_t codes = 0;
            std::size_t const last = std::min(table + 16, bytes.size() - 1);
            for (std::size_t length = table + 1; length <= last; ++length) codes += at(length);
            if (codes > 256)
                throw Error(ErrorKind::bad_input, "picture can't be decoded: JPEG with a table of " +
                                                      std::to_string(codes) + " codes, 256 are possible");
            table += 17 + codes;
        }
        i = std::max(end, i + 1);
    }
}

/// The file without PNG chunks of picture data that hold nothing, which are allowed: stb_image copies 0 bytes to a null
/// pointer for the first. Empty where there is none of them, or no PNG.
std::vector<std::byte> without_empty_data(std::span<std::byte const> bytes) {
    constexpr std::size_t signature = 8, frame = 12; // length, type and checksum
    constexpr unsigned char png[signature] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    constexpr unsigned char nothing[8] = {0, 0, 0, 0, 'I', 'D', 'A', 'T'};
    if (bytes.size() < signature || std::memcmp(bytes.data(), png, signature) != 0) return {};
    std::vector<std::byte> kept;
    for (std::size_t i = signature; i < bytes.size();) {
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4 && i + k < bytes.size(); ++k)
            length = length * 256 + std::to_integer<std::size_t>(bytes[i + k]);
        std::size_t const end = i + std::min(length + frame, bytes.size() - i);
        bool const empty = end - i >= sizeof nothing && std::memcmp(&bytes[i], nothing, sizeof nothing) == 0;
        if (empty && kept.empty())
            kept.assign(bytes.begin(), bytes.begin() + std::ptrdiff_t(i));
        else if (!empty && !kept.empty())
            kept.insert(kept.end(), bytes.begin() + std::ptrdiff_t(i), bytes.begin() + std::ptrdiff_t(end));
        i = end;
    }
    return kept;
}

void append(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<std::byte>*>(context);
    auto const* const first = static_cast<std::byte const*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

} // namespace

std::vector<std::byte> encode_png(ByteImage const& image) {
    bool opaque = true;
    for (std::size_t i = 3; i < image.rgba.size() && opaque; i += 4) opaque = image.rgba[i] == 255;
    std::vector<std::uint8_t> rgb;
    if (opaque) {
        rgb.resize(image.extent.pixels() * 3);
        for (std::size_t i = 0; i < image.extent.pixels(); ++i) std::memcpy(&rgb[i * 3], &image.rgba[i * 4], 3);
    }
    int const channels = opaque ? 3 : 4;
    std::vector<std::byte> bytes;
    stbi_write_png_compression_level = 1;
    stbi_write_force_png_filter =
        1; // the pixel to the left; trying every filter takes half as long again and gains nothing
    int const width = static_cast<int>(image.extent.width);
    if (!stbi_write_png_to_func(append, &bytes, width, static_cast<int>(image.extent.height), channels,
                                opaque ? rgb.data() : image.rgba.data(), width * channels)) {
        throw Error(ErrorKind::bad_input, "picture can't be encoded");
    }
    return bytes;
}

std::vector<std::byte> encode_jpeg(ByteImage const& image, int quality) {
    std::vector<std::byte> bytes;
    if (!stbi_write_jpg_to_func(append, &bytes, static_cast<int>(image.extent.width),
                                static_cast<int>(image.extent.height), 4, image.rgba.data(), quality)) {
        throw Error(ErrorKind::bad_input, "picture can't be encoded");
    }
    return bytes;
}

void write_png(std::filesystem::path const& path, ByteImage const& image) { write_file(path, encode_png(image)); }

PictureHeader read_picture_header(std::span<std::byte const> bytes) {
    if (is_webp(bytes)) return read_webp_header(bytes);
    check_code_tables(bytes); // headers have them before the size
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(data_of(bytes), length_of(bytes), &width, &height, &channels)) fail();
    PictureHeader header;
    header.extent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    header.channels = channels;
    header.bits = stbi_is_16_bit_from_memory(data_of(bytes), length_of(bytes)) ? 16 : 8;
    return header;
}

ByteImage decode_picture(std::span<std::byte const> bytes) {
    if (is_webp(bytes)) return decode_webp(bytes);
    check_scans(bytes);
    std::vector<std::byte> const mended = without_empty_data(bytes);
    if (!mended.empty()) bytes = mended;
    StbMemory const bound(bytes);
    int width = 0, height = 0, channels = 0;
    std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> const pixels(
        stbi_load_from_memory(data_of(bytes), length_of(bytes), &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) fail();
    ByteImage image;
    image.extent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    image.rgba.assign(pixels.get(), pixels.get() + image.extent.pixels() * 4);
    return image;
}

DeepImage decode_deep_picture(std::span<std::byte const> bytes) {
    std::vector<std::byte> const mended = without_empty_data(bytes);
    if (!mended.empty()) bytes = mended;
    int width = 0, height = 0, channels = 0;
    std::unique_ptr<stbi_us, decltype(&stbi_image_free)> const pixels(
        stbi_load_16_from_memory(data_of(bytes), length_of(bytes), &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) fail();
    DeepImage image({static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)});
    std::copy_n(pixels.get(), image.rgba.size(), image.rgba.data());
    return image;
}

ByteImage read_picture(std::filesystem::path const& path) {
    try {
        return decode_picture(read_file(path));
    } catch (Error const& error) {
        if (std::string_view(error.what()).starts_with(path.string())) throw;
        throw Error(error.kind(), error.what(), path.string());
    }
}

} // namespace alpenglow
