#include "scene/gltf_pictures.h"

#include "core/error.h"
#include "core/parallel.h"
#include "image/codec.h"
#include "scene/gltf_resources.h"

#include <algorithm>
#include <array>

namespace alpenglow::gltf {

namespace {

/// The mean of each two by two texels, of the values as stored; a last odd row or column is left out.
ByteImage halved(ByteImage const& image) {
    ByteImage half({std::max(image.extent.width / 2, 1u), std::max(image.extent.height / 2, 1u)});
    std::uint32_t const right = image.extent.width > 1, down = image.extent.height > 1;
    for (std::uint32_t y = 0; y < half.extent.height; ++y) {
        for (std::uint32_t x = 0; x < half.extent.width; ++x) {
            std::uint32_t const u = x * (1 + right), v = y * (1 + down);
            for (int c = 0; c < 4; ++c) {
                int const sum = image.at(u, v)[c] + image.at(u + right, v)[c] + image.at(u, v + down)[c] +
                                image.at(u + right, v + down)[c];
                half.at(x, y)[c] = static_cast<std::uint8_t>((sum + 2) / 4);
            }
        }
    }
    return half;
}

void check_extent(Extent const& extent, std::string const& pointer, Report const& report) {
    GltfLimits const& limits = report.limits();
    std::string const is = "is a picture of " + std::to_string(extent.width) + " x " + std::to_string(extent.height);
    if (std::max(extent.width, extent.height) > static_cast<std::uint32_t>(limits.largest_picture))
        report.refuse_beyond("largest_picture", limits.largest_picture, pointer, is + " texels");
    if (extent.pixels() > static_cast<std::uint64_t>(limits.most_pixels) << 20)
        report.refuse_beyond("most_pixels", limits.most_pixels, pointer, is + " or Mi texels");
}

ByteImage decode(std::vector<std::byte> const& bytes, std::string const& pointer, Report const& report) {
    try {
        Extent const extent = read_picture_header(bytes).extent;
        check_extent(extent, pointer, report);
        return decode_picture(bytes);
    } catch (Error const& error) {
        if (dynamic_cast<GltfError const*>(&error)) throw;
        report.refuse("IMAGE_DATA_INVALID", pointer, error.what(), "PNG, JPEG and WebP are read");
    }
}

Picture scaled_picture(ByteImage image, Document const& document, std::size_t index, int largest, Report& report) {
    Extent const stored = image.extent;
    auto const limit = static_cast<std::uint32_t>(std::max(largest, 1));
    while (std::max(image.extent.width, image.extent.height) > limit) image = halved(image);
    if (image.extent != stored) {
        report.warn("/images/" + std::to_string(index) + " of " + std::to_string(stored.width) + " x " +
                    std::to_string(stored.height) + " is scaled down to " + std::to_string(image.extent.width) + " x " +
                    std::to_string(image.extent.height) + " (setting largest_texture)");
    }
    return {document.images[index].name, image.extent.width, image.extent.height, std::move(image.rgba)};
}

/// Numbers the images that any material uses by their first use, writes the numbers into the textures, and gives the
/// images.
std::vector<std::size_t> number_pictures(std::vector<Material>& materials, std::size_t images) {
    std::vector<std::size_t> used;
    std::vector<std::uint32_t> numbers(images, Texture::none);
    for (Material& material : materials) {
        for (Texture* const texture :
             {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
              &material.occlusion_texture, &material.emission_texture}) {
            if (!*texture) continue;
            std::uint32_t& number = numbers[texture->picture];
            if (number == Texture::none) {
                number = static_cast<std::uint32_t>(used.size());
                used.push_back(texture->picture);
            }
            texture->picture = number;
        }
    }
    return used;
}

} // namespace

std::vector<Picture> load_pictures(Document const& document, std::vector<Material>& materials, int largest,
                                   Report& report) {
    std::vector<std::size_t> const used = number_pictures(materials, document.images.size());
    std::vector<std::vector<std::byte>> files;
    for (std::size_t index : used) files.push_back(read_image_bytes(document, index, report));
    std::vector<ByteImage> images(used.size());
    parallel_for(static_cast<int>(used.size()), 0, [&](int i) {
        auto const n = static_cast<std::size_t>(i);
        images[n] = decode(files[n], "/images/" + std::to_string(used[n]), report);
    });
    std::vector<Picture> pictures;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (read_picture_header(files[i]).bits == 16) report.warn("pictures of 16 bits a channel are read as 8");
        pictures.push_back(scaled_picture(std::move(images[i]), document, used[i], largest, report));
    }
    return pictures;
}

} // namespace alpenglow::gltf
