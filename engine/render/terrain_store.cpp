#include "render/terrain_store.h"

#include "gpu/transfer.h"

#include <array>
#include <cstring>

namespace alpenglow {

namespace {

constexpr VkImageUsageFlags KEPT = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

std::uint32_t side_of(TerrainFit const& fit) { return fit.size > 0 ? static_cast<std::uint32_t>(fit.size) : 1; }

} // namespace

bool TerrainLightCause::operator==(TerrainLightCause const& other) const {
    return fit == other.fit && ceiling == other.ceiling && std::memcmp(&air, &other.air, sizeof air) == 0;
}

bool TerrainStore::fits(TerrainFit const& fit) const { return light_ && light_->shape().extent.width == side_of(fit); }

void TerrainStore::replace(TerrainFit const& fit) {
    discard();
    Extent const size{side_of(fit), side_of(fit)};
    auto const make = [&](VkFormat format, Extent extent, VkImageUsageFlags usage, char const* name) {
        return std::make_unique<GpuImage>(device_, ImageShape{format, extent}, KEPT | usage, name);
    };
    albedo_ = make(VK_FORMAT_R8G8B8A8_SRGB, size, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "terrain_albedo");
    normal_ = make(VK_FORMAT_R16G16B16A16_SNORM, size, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "terrain_normal");
    depth_ = make(VK_FORMAT_D32_SFLOAT, size, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, "terrain_depth");
    light_ = make(VK_FORMAT_R16G16B16A16_SFLOAT, {size.width, TERRAIN_LIGHT_TILES * size.height},
                  VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "terrain_light");
    std::uint32_t const coarse = (size.width + TERRAIN_AIR_TEXELS - 1) / TERRAIN_AIR_TEXELS;
    air_ = make(VK_FORMAT_R16G16B16A16_SFLOAT, {coarse, TERRAIN_AIR_TILES * coarse},
                VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "terrain_air");
    if (fit.size > 0) return;
    constexpr std::array<std::uint64_t, TERRAIN_LIGHT_TILES> BLACK{};
    upload(device_, *light_, std::as_bytes(std::span(BLACK)));
    upload(device_, *air_, std::as_bytes(std::span(BLACK).first<TERRAIN_AIR_TILES>()));
}

TerrainMaps TerrainStore::of(TerrainLightCause const& cause, bool tables_change) const {
    bool const has_map = cause.fit.size > 0;
    return {cause,  *albedo_, *normal_, *depth_, *light_, *air_, has_map && drawn_ != cause.fit,
            has_map && (tables_change || made_ != cause)};
}

void TerrainStore::finish(TerrainMaps const& maps) {
    drawn_ = maps.fit();
    if (maps.light_is_new) made_ = maps.cause;
}

} // namespace alpenglow
