#include "scene/gltf_pictures.h"

#include "core/error.h"
#include "core/parallel.h"
#include "image/codec.h"
#include "scene/gltf_resources.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

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
    std::string const is = fmt::format("is a picture of {} x {}", extent.width, extent.height);
    if (std::max(extent.width, extent.height) > static_cast<std::uint32_t>(limits.largest_picture))
        report.refuse_beyond("largest_picture", limits.largest_picture, pointer, is + " texels");
    if (extent.pixels() > static_cast<std::uint64_t>(limits.most_pixels) << 20)
        report.refuse_beyond("most_pixels", limits.most_pixels, pointer,
                             fmt::format("{}, {:.1f} Mi texels", is, static_cast<double>(extent.pixels()) / (1 << 20)));
}

/// Calls `read`; what it can't make of the picture is the file's fault.
template <class Read> auto refusing(std::string const& pointer, Report const& report, Read const& read) {
    try {
        return read();
    } catch (GltfError const&) {
        throw;
    } catch (Error const& error) {
        report.refuse("IMAGE_DATA_INVALID", pointer, error.what(), "PNG, JPEG and WebP are read");
    }
}

Extent scaled(Extent extent, std::uint32_t largest) {
    while (std::max(extent.width, extent.height) > largest)
        extent = {std::max(extent.width / 2, 1u), std::max(extent.height / 2, 1u)};
    return extent;
}

/// What the headers say, before anything is decoded.
std::vector<PictureHeader> read_headers(std::vector<std::size_t> const& used,
                                        std::vector<std::vector<std::byte>> const& files, std::uint32_t largest,
                                        Report const& report) {
    std::vector<PictureHeader> headers;
    std::uint64_t pixels = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
        std::string const pointer = fmt::format("/images/{}", used[i]);
        headers.push_back(refusing(pointer, report, [&] { return read_picture_header(files[i]); }));
        check_extent(headers.back().extent, pointer, report);
        pixels += scaled(headers.back().extent, largest).pixels();
        if (int const most = report.limits().most_pixels_in_all; pixels > static_cast<std::uint64_t>(most) << 20)
            report.refuse_beyond("most_pixels_in_all", most, pointer,
                                 fmt::format("makes {:.1f} Mi texels in all", static_cast<double>(pixels) / (1 << 20)));
    }
    return headers;
}

void say_what_changes(PictureHeader const& header, std::size_t image, std::uint32_t largest, Report& report) {
    if (header.bits == 16) report.warn("pictures of 16 bits a channel are read as 8");
    Extent const stored = header.extent, made = scaled(stored, largest);
    if (made == stored) return;
    report.warn(fmt::format("/images/{} of {} x {} is scaled down to {} x {} (setting largest_texture)", image,
                            stored.width, stored.height, made.width, made.height));
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

std::vector<Picture> load_pictures(Document const& document, std::vector<Material>& materials, int largest_texture,
                                   Report& report, std::function<void()> const& decoded) {
    auto const largest = static_cast<std::uint32_t>(std::max(largest_texture, 1));
    std::vector<std::size_t> const used = number_pictures(materials, document.images.size());
    std::vector<std::vector<std::byte>> files;
    for (std::size_t index : used) files.push_back(read_image_bytes(document, index, report));
    std::vector<PictureHeader> const headers = read_headers(used, files, largest, report);
    std::vector<Picture> pictures(used.size());
    parallel_for(static_cast<int>(used.size()), 0, [&](int i) {
        auto const n = static_cast<std::size_t>(i);
        ByteImage image =
            refusing(fmt::format("/images/{}", used[n]), report, [&] { return decode_picture(files[n]); });
        while (image.extent != scaled(image.extent, largest)) image = halved(image);
        pictures[n] = {document.images[used[n]].name, image.extent.width, image.extent.height, std::move(image.rgba)};
        decoded();
    });
    for (std::size_t i = 0; i < used.size(); ++i) say_what_changes(headers[i], used[i], largest, report);
    return pictures;
}

} // namespace alpenglow::gltf
