#include "image/exr.h"

#include "core/error.h"
#include "core/files.h"
#include "image/exr_streams.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

namespace alpenglow {

namespace {

constexpr int LARGEST_SIDE = 32768;
constexpr std::size_t MOST_PIXELS = std::size_t{1} << 26;
constexpr std::size_t PIXEL_BYTES = 4 * sizeof(float);
constexpr std::array<char const*, 4> CHANNELS{"R", "G", "B", "A"};
std::string const VARIANCE = "variance."; ///< before the channels' letters

using TextAttributes = std::map<std::string, std::string>;

bool has_alpha(FloatImage const& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 1.0f) return true;
    }
    return false;
}

/// One picture of a file: its channels are PREFIX and then R, G, B and perhaps A.
struct Layer {
    std::string prefix;
    FloatImage const& image;
    std::size_t channels; ///< 3 or 4
};

/// OpenEXR addresses pixels from the origin of the data window's coordinates, which may lie outside the picture.
void add_slices(Imf::FrameBuffer& buffer, std::string const& prefix, float* first, Imath::Box2i const& window,
                std::size_t channels) {
    std::size_t const row = PIXEL_BYTES * static_cast<std::size_t>(window.max.x - window.min.x + 1);
    for (std::size_t c = 0; c < channels; ++c) {
        buffer.insert(prefix + CHANNELS[c],
                      Imf::Slice::Make(Imf::FLOAT, first + c, window, PIXEL_BYTES, row, 1, 1, c == 3 ? 1.0 : 0.0));
    }
}

std::vector<std::byte> encode(std::span<Layer const> layers, TextAttributes const& attributes) {
    Extent const extent = layers.front().image.extent;
    int const width = static_cast<int>(extent.width), height = static_cast<int>(extent.height);
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities()); // the default is Rec.709 with D65
    for (auto const& [name, text] : attributes) header.insert(name, Imf::StringAttribute(text));

    Imf::FrameBuffer buffer;
    for (Layer const& layer : layers) {
        for (std::size_t c = 0; c < layer.channels; ++c) {
            header.channels().insert(layer.prefix + CHANNELS[c], Imf::Channel(Imf::FLOAT));
        }
        // OpenEXR only reads from the buffer of an output file, although its type is not const.
        add_slices(buffer, layer.prefix, const_cast<float*>(layer.image.rgba.data()), header.dataWindow(),
                   layer.channels);
    }
    MemoryWriter writer;
    {
        Imf::OutputFile file(writer, header);
        file.setFrameBuffer(buffer);
        file.writePixels(height);
    }
    return writer.take();
}

Extent checked_extent(Imath::Box2i const& window) {
    auto const width = std::int64_t{window.max.x} - window.min.x + 1,
               height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > LARGEST_SIDE || height > LARGEST_SIDE ||
        static_cast<std::size_t>(width * height) > MOST_PIXELS) {
        throw Error(ErrorKind::bad_input,
                    "EXR picture of " + std::to_string(width) + "x" + std::to_string(height) +
                        " pixels is beyond the limit of 2^26 pixels",
                    {}, "use a smaller one");
    }
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

void check_channels(Imf::ChannelList const& channels, std::string const& prefix) {
    for (char const* const letter : CHANNELS) {
        std::string const name = prefix + letter;
        Imf::Channel const* const channel = channels.findChannel(name);
        if (!channel && *letter == 'A') continue;
        if (!channel) {
            throw Error(ErrorKind::bad_input, "EXR file has no channel " + name, {}, prefix + "R, G and B are needed");
        }
        if (channel->type == Imf::UINT || channel->xSampling != 1 || channel->ySampling != 1) {
            throw Error(ErrorKind::bad_input, "EXR channel " + name + " is of integers or subsampled", {},
                        "half or float at full resolution is needed");
        }
    }
}

FloatImage read_layer(Imf::InputFile& file, std::string const& prefix) {
    Imath::Box2i const window = file.header().dataWindow();
    FloatImage image(checked_extent(window));
    check_channels(file.header().channels(), prefix);
    Imf::FrameBuffer buffer;
    add_slices(buffer, prefix, image.rgba.data(), window, CHANNELS.size());
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

bool has_variance(Imf::ChannelList const& channels) {
    return std::any_of(CHANNELS.begin(), CHANNELS.begin() + 3,
                       [&](char const* name) { return channels.findChannel(VARIANCE + name) != nullptr; });
}

TextAttributes text_attributes(Imf::Header const& header) {
    TextAttributes result;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
        auto const* const text = dynamic_cast<Imf::StringAttribute const*>(&attribute.attribute());
        if (text) result[attribute.name()] = text->value();
    }
    return result;
}

RadianceRecord read_layers(Imf::InputFile& file) {
    RadianceRecord record{read_layer(file, ""), {}, text_attributes(file.header())};
    if (has_variance(file.header().channels())) record.variance = read_layer(file, VARIANCE);
    return record;
}

/// OpenEXR makes room for as many bytes as an attribute of the header claims to have, before it looks for them.
void check_attribute_sizes(std::span<std::byte const> bytes) {
    constexpr std::size_t magic_and_version = 8;
    std::size_t at = magic_and_version;
    auto const skip_text = [&] {
        while (at < bytes.size() && bytes[at] != std::byte{0}) ++at;
        ++at;
    };
    while (at < bytes.size() && bytes[at] != std::byte{0}) {
        skip_text(); // name
        skip_text(); // type
        std::uint32_t size = 0;
        if (at + sizeof size > bytes.size()) return;
        std::memcpy(&size, &bytes[at], sizeof size); // little endian, as this machine is
        at += sizeof size;
        if (size > bytes.size() - at)
            throw Error(ErrorKind::bad_input, "EXR file is cut short within its header", {}, WHOLE_EXR_NEEDED);
        at += size;
    }
}

/// OpenEXR's own messages span lines and name its sources; the first line says enough.
std::string first_line(std::exception const& error) {
    std::string const text = error.what();
    return text.substr(0, text.find('\n'));
}

/// What `read` makes of the open file; all that goes wrong there is an Error of one line.
template <typename Read> auto decode(std::span<std::byte const> bytes, Read read) {
    // Before the header is trusted with a table of lines; the limit belongs to OpenEXR's process-wide state.
    static bool const limited = (Imf::Header::setMaxImageSize(LARGEST_SIDE, LARGEST_SIDE), true);
    static_cast<void>(limited);
    check_attribute_sizes(bytes);
    try {
        MemoryReader reader(bytes);
        Imf::InputFile file(reader);
        return read(file);
    } catch (Error const&) {
        throw;
    } catch (std::bad_alloc const&) {
        throw Error(ErrorKind::bad_input, "EXR picture does not fit into memory", {}, "use a smaller one");
    } catch (std::exception const& error) {
        throw Error(ErrorKind::bad_input, "EXR picture can't be decoded: " + first_line(error), {}, WHOLE_EXR_NEEDED);
    }
}

template <typename Decode> auto decode_file(std::filesystem::path const& path, Decode decode_bytes) {
    std::vector<std::byte> const bytes = read_file(path);
    try {
        return decode_bytes(bytes);
    } catch (Error const& error) {
        throw Error(error.kind(), error.what(), path.string());
    }
}

void require_pixels(FloatImage const& image) {
    if (image.extent.pixels() == 0) throw Error(ErrorKind::bad_input, "a picture without pixels can't be encoded");
}

/// A longer name, or one with a zero in it, can't be read back.
void require_attribute_name(std::string const& name) {
    constexpr std::size_t longest = 255;
    if (!name.empty() && name.size() <= longest && name.find('\0') == std::string::npos) return;
    throw Error(ErrorKind::bad_input, "'" + name + "' can't name an EXR attribute", {}, "give 1 to 255 letters");
}

} // namespace

std::vector<std::byte> encode_exr(FloatImage const& image) {
    require_pixels(image);
    Layer const layer{"", image, has_alpha(image) ? std::size_t{4} : std::size_t{3}};
    return encode({&layer, 1}, {});
}

std::vector<std::byte> encode_exr(RadianceRecord const& record) {
    require_pixels(record.radiance);
    std::vector<Layer> layers{{"", record.radiance, 3}};
    if (record.variance) {
        if (record.variance->extent != record.radiance.extent) {
            throw Error(ErrorKind::bad_input, "a variance picture needs the extent of its radiance");
        }
        layers.push_back({VARIANCE, *record.variance, 3});
    }
    for (auto const& [name, text] : record.attributes) require_attribute_name(name);
    try {
        return encode(layers, record.attributes);
    } catch (std::exception const& error) {
        throw Error(ErrorKind::bad_input, "EXR record can't be encoded: " + first_line(error));
    }
}

void write_exr(std::filesystem::path const& path, FloatImage const& image) { write_file(path, encode_exr(image)); }
void write_exr(std::filesystem::path const& path, RadianceRecord const& record) {
    write_file(path, encode_exr(record));
}

FloatImage decode_exr(std::span<std::byte const> bytes) {
    return decode(bytes, [](Imf::InputFile& file) { return read_layer(file, ""); });
}

RadianceRecord decode_record(std::span<std::byte const> bytes) { return decode(bytes, read_layers); }

FloatImage read_exr(std::filesystem::path const& path) { return decode_file(path, decode_exr); }

RadianceRecord read_record(std::filesystem::path const& path) { return decode_file(path, decode_record); }

} // namespace alpenglow
