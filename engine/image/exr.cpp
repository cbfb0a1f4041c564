#include "image/exr.h"

#include "core/error.h"
#include "core/files.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

namespace alpenglow {

namespace {

constexpr int LARGEST_SIDE = 32768;
constexpr std::size_t MOST_PIXELS = std::size_t{1} << 26;
constexpr std::size_t PIXEL_BYTES = 4 * sizeof(float);
constexpr std::array<char const*, 4> CHANNELS{"R", "G", "B", "A"};

class MemoryWriter : public Imf::OStream {
public:
    MemoryWriter() : OStream("memory") {}

    void write(char const* data, int size) override {
        std::size_t const end = position_ + static_cast<std::size_t>(size);
        if (end > bytes_.size()) bytes_.resize(end);
        std::memcpy(bytes_.data() + position_, data, static_cast<std::size_t>(size));
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

class MemoryReader : public Imf::IStream {
public:
    explicit MemoryReader(std::span<std::byte const> bytes) : IStream("memory"), bytes_(bytes) {}

    bool read(char* data, int size) override {
        auto const wanted = static_cast<std::size_t>(size);
        if (position_ > bytes_.size() || wanted > bytes_.size() - position_) {
            throw Error(ErrorKind::bad_input, "EXR file is cut short");
        }
        std::memcpy(data, bytes_.data() + position_, wanted);
        position_ += wanted;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::span<std::byte const> bytes_;
    std::uint64_t position_ = 0;
};

bool has_alpha(FloatImage const& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 1.0f) return true;
    }
    return false;
}

/// OpenEXR addresses pixels from the origin of the data window's coordinates, which may lie outside the picture.
Imf::FrameBuffer frame_buffer(float* first, Imath::Box2i const& window, std::size_t channels) {
    std::size_t const row = PIXEL_BYTES * static_cast<std::size_t>(window.max.x - window.min.x + 1);
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < channels; ++c) {
        buffer.insert(CHANNELS[c],
                      Imf::Slice::Make(Imf::FLOAT, first + c, window, PIXEL_BYTES, row, 1, 1, c == 3 ? 1.0 : 0.0));
    }
    return buffer;
}

std::vector<std::byte> encode(FloatImage const& image) {
    int const width = static_cast<int>(image.extent.width), height = static_cast<int>(image.extent.height);
    std::size_t const channels = has_alpha(image) ? 4 : 3;
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (std::size_t c = 0; c < channels; ++c) header.channels().insert(CHANNELS[c], Imf::Channel(Imf::FLOAT));
    Imf::addChromaticities(header, Imf::Chromaticities()); // the default is Rec.709 with D65

    MemoryWriter writer;
    {
        // OpenEXR only reads from the buffer of an output file, although its type is not const.
        Imf::OutputFile file(writer, header);
        file.setFrameBuffer(frame_buffer(const_cast<float*>(image.rgba.data()), header.dataWindow(), channels));
        file.writePixels(height);
    }
    return writer.take();
}

Extent checked_extent(Imath::Box2i const& window) {
    auto const width = std::int64_t{window.max.x} - window.min.x + 1,
               height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > LARGEST_SIDE || height > LARGEST_SIDE ||
        static_cast<std::size_t>(width * height) > MOST_PIXELS) {
        throw Error(ErrorKind::bad_input, "EXR picture of " + std::to_string(width) + "x" + std::to_string(height) +
                                              " pixels is beyond the limit of 2^26 pixels");
    }
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

void check_channels(Imf::ChannelList const& channels) {
    for (char const* const name : CHANNELS) {
        Imf::Channel const* const channel = channels.findChannel(name);
        if (!channel && *name == 'A') continue;
        if (!channel)
            throw Error(ErrorKind::bad_input, std::string("EXR file has no channel ") + name, {},
                        "R, G and B are needed");
        if (channel->type == Imf::UINT || channel->xSampling != 1 || channel->ySampling != 1) {
            throw Error(ErrorKind::bad_input, std::string("EXR channel ") + name + " is of integers or subsampled", {},
                        "half or float at full resolution is needed");
        }
    }
}

FloatImage decode(std::span<std::byte const> bytes) {
    MemoryReader reader(bytes);
    Imf::InputFile file(reader);
    Imath::Box2i const window = file.header().dataWindow();
    FloatImage image(checked_extent(window));
    check_channels(file.header().channels());
    file.setFrameBuffer(frame_buffer(image.rgba.data(), window, CHANNELS.size()));
    file.readPixels(window.min.y, window.max.y);
    return image;
}

/// OpenEXR's own messages span lines and name its sources; the first line says enough.
std::string first_line(std::exception const& error) {
    std::string const text = error.what();
    return text.substr(0, text.find('\n'));
}

} // namespace

std::vector<std::byte> encode_exr(FloatImage const& image) {
    if (image.extent.pixels() == 0) throw Error(ErrorKind::bad_input, "a picture without pixels can't be encoded");
    return encode(image);
}

void write_exr(std::filesystem::path const& path, FloatImage const& image) { write_file(path, encode_exr(image)); }

FloatImage decode_exr(std::span<std::byte const> bytes) {
    // Before the header is trusted with a table of lines; the limit belongs to OpenEXR's process-wide state.
    static bool const limited = (Imf::Header::setMaxImageSize(LARGEST_SIDE, LARGEST_SIDE), true);
    static_cast<void>(limited);
    try {
        return decode(bytes);
    } catch (Error const&) {
        throw;
    } catch (std::bad_alloc const&) {
        throw Error(ErrorKind::bad_input, "EXR picture does not fit into memory");
    } catch (std::exception const& error) {
        throw Error(ErrorKind::bad_input, "EXR picture can't be decoded: " + first_line(error));
    }
}

FloatImage read_exr(std::filesystem::path const& path) {
    std::vector<std::byte> const bytes = read_file(path);
    try {
        return decode_exr(bytes);
    } catch (Error const& error) {
        throw Error(error.kind(), error.what(), path.string());
    }
}

} // namespace alpenglow
