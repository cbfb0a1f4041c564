#include "render/ceiling_store.h"

#include "gpu/transfer.h"

namespace alpenglow {

namespace {

constexpr VkImageUsageFlags USAGE = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

constexpr glm::vec2 LIT_TEXEL(CEILING_NONE, 0);

std::uint32_t side_of(CeilingFit const& fit) { return fit.size > 0 ? static_cast<std::uint32_t>(fit.size) : 1; }

} // namespace

bool CeilingStore::fits(CeilingFit const& fit) const { return map_ && map_->shape().extent.width == side_of(fit); }

void CeilingStore::replace(CeilingFit const& fit) {
    Extent const size{side_of(fit), side_of(fit)};
    map_.reset();
    map_ = std::make_unique<GpuImage>(device_, ImageShape{VK_FORMAT_R32G32_SFLOAT, size}, USAGE, "shadow_ceiling");
    if (fit.size == 0) upload(device_, *map_, std::as_bytes(std::span(&LIT_TEXEL, 1)));
    discard();
}

} // namespace alpenglow
