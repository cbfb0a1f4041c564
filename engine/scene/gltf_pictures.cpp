#include "scene/gltf_pictures.h"

#include "core/error.h"
#include "core/parallel.h"
#include "image/codec.h"
#include "image/color.h"
#include "scene/gltf_resources.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <fmt/format.h>

namespace alpenglow::gltf {

namespace {

std::uint8_t mean_light(std::array<std::uint8_t, 4> const& v) {
    float const sum = linear_from_srgb_byte(v[0]) + linear_from_srgb_byte(v[1]) + linear_from_srgb_byte(v[2]) +
                      linear_from_srgb_byte(v[3]);
    return srgb_byte_from_linear(sum / 4);
}

std::uint16_t mean_light(std::array<std::uint16_t, 4> const& v) {
    float const sum = linear_from_srgb_word(v[0]) + linear_from_srgb_word(v[1]) + linear_from_srgb_word(v[2]) +
                      linear_from_srgb_word(v[3]);
    return srgb_word_from_linear(sum / 4);
}

template <class Value> Value mean_value(std::array<Value, 4> const& v) {
    return static_cast<Value>((std::uint32_t{v[0]} + v[1] + v[2] + v[3] + 2) / 4);
}

/// The mean of each two by two texels, of `srgb` colours as light and of all else as stored; a last odd row or column
/// is left out.
template <class Image> Image halved(Image const& image, bool srgb) {
    Image half({std::max(image.extent.width / 2, 1u), std::max(image.extent.height / 2, 1u)});
    std::uint32_t const right = image.extent.width > 1, down = image.extent.height > 1;
    for (std::uint32_t y = 0; y < half.extent.height; ++y) {
        for (std::uint32_t x = 0; x < half.extent.width; ++x) {
            std::uint32_t const u = x * (1 + right), v = y * (1 + down);
            for (int c = 0; c < 4; ++c) {
                std::array const four{image.at(u, v)[c], image.at(u + right, v)[c], image.at(u, v + down)[c],
                                      image.at(u + right, v + down)[c]};
                half.at(x, y)[c] = srgb && c < 3 ? mean_light(four) : mean_value(four);
            }
        }
    }
    return half;
}

void check_extent(Extent const& extent, std::string const& pointer, Report const& report) {
    GltfLimits const& limits = report.limits();
    std::string const is = fmt::format("is a picture of {} x {}", extent.width, extent.height);
    if (std::max(extent.width, extent.height) > static_cast<std::uint32_t>(limits.largest_picture))
        report.refuse_beyond("largest_picture", limits.largest_picture, pointer, is + " texels");
    if (extent.pixels() > static_cast<std::uint64_t>(limits.most_pixels) << 20)
        report.refuse_beyond("most_pixels", limits.most_pixels, pointer,
                             fmt::format("{}, {:.1f} Mi texels", is, static_cast<double>(extent.pixels()) / (1 << 20)));
}

/// An image that materials use, and how.
struct UsedImage {
    std::size_t index;
    bool srgb = false; ///< at least one use takes it for colours
};

/// `extent` halved until it fits.
Extent fitted(Extent extent, std::uint32_t largest) {
    while (std::max(extent.width, extent.height) > largest)
        extent = {std::max(extent.width / 2, 1u), std::max(extent.height / 2, 1u)};
    return extent;
}

/// Reads and decodes images, several at a time if need be.
class Decoder {
public:
    Decoder(Document const& document, int largest, Report const& report)
        : document_(document), largest_(static_cast<std::uint32_t>(std::max(largest, 1))), report_(report) {}

    struct Result {
        Picture picture;
        Extent stored;
    };
    Result decode(UsedImage const& image) {
        std::string const pointer = "/images/" + std::to_string(image.index);
        std::vector<std::byte> const file = read_image_bytes(document_, image.index, report_);
        try {
            PictureHeader const header = read_picture_header(file);
            check_extent(header.extent, pointer, report_);
            bool const deep = header.bits == 16;
            claim(fitted(header.extent, largest_).pixels() * (deep ? 8 : 4));
            Result result{{document_.images[image.index].name, 0, 0, {}}, header.extent};
            if (deep)
                result.picture.rgba16 = scaled(decode_deep_picture(file), image.srgb, result.picture);
            else
                result.picture.rgba = scaled(decode_picture(file), image.srgb, result.picture);
            return result;
        } catch (GltfError const&) {
            throw;
        } catch (Error const& error) {
            report_.refuse("IMAGE_DATA_INVALID", pointer, error.what(), "PNG, JPEG and WebP are read");
        }
    }

private:
    /// A small file may name one picture again and again.
    void claim(std::uint64_t bytes) {
        int const most = report_.limits().most_picture_memory;
        std::uint64_t const all = claimed_ += bytes;
        if (all > static_cast<std::uint64_t>(most) << 20)
            report_.refuse_beyond("most_picture_memory", most, "/images",
                                  fmt::format("take {} MiB or more once decoded", all >> 20));
    }

    /// Halves the image until it fits, notes its extent and returns its texels.
    template <class Image> decltype(Image::rgba) scaled(Image image, bool srgb, Picture& picture) const {
        while (std::max(image.extent.width, image.extent.height) > largest_) image = halved(image, srgb);
        picture.width = image.extent.width, picture.height = image.extent.height;
        return std::move(image.rgba);
    }

    Document const& document_;
    std::uint32_t largest_; ///< [texels]
    Report const& report_;
    std::atomic<std::uint64_t> claimed_ = 0; ///< [bytes]
};

/// Numbers the images that any material uses by their first use, writes the numbers into the textures, and gives the
/// images.
std::vector<UsedImage> number_pictures(std::vector<Material>& materials, std::size_t images) {
    std::vector<UsedImage> used;
    std::vector<std::uint32_t> numbers(images, Texture::none);
    auto const number = [&](Texture& texture, bool srgb) {
        if (!texture) return;
        std::uint32_t& known = numbers[texture.picture];
        if (known == Texture::none) {
            known = static_cast<std::uint32_t>(used.size());
            used.push_back({texture.picture});
        }
        used[known].srgb |= srgb;
        texture.picture = known;
    };
    for (Material& material : materials) {
        number(material.base_color_texture, true);
        number(material.metallic_roughness_texture, false);
        number(material.normal_texture, false);
        number(material.occlusion_texture, false);
        number(material.emission_texture, true);
        number(material.specular_texture, false);
        number(material.reflectance_texture, true);
    }
    return used;
}

void warn_of_scaling(UsedImage const& image, Decoder::Result const& decoded, Report& report) {
    Picture const& picture = decoded.picture;
    if (decoded.stored == Extent{picture.width, picture.height}) return;
    report.warn(fmt::format("/images/{} of {} x {} is scaled down to {} x {} (setting largest_texture)", image.index,
                            decoded.stored.width, decoded.stored.height, picture.width, picture.height));
}

} // namespace

std::vector<Picture> load_pictures(Document const& document, std::vector<Material>& materials, int largest,
                                   Report& report, std::function<void()> const& one_is_decoded) {
    std::vector<UsedImage> const used = number_pictures(materials, document.images.size());
    std::vector<Decoder::Result> decoded(used.size());
    Decoder decoder(document, largest, report);
    parallel_for(static_cast<int>(used.size()), 0, [&](int i) {
        auto const n = static_cast<std::size_t>(i);
        decoded[n] = decoder.decode(used[n]);
        one_is_decoded();
    });
    std::vector<Picture> pictures;
    for (std::size_t i = 0; i < used.size(); ++i) {
        warn_of_scaling(used[i], decoded[i], report);
        pictures.push_back(std::move(decoded[i].picture));
    }
    return pictures;
}

} // namespace alpenglow::gltf
