#include "gpu/transfer.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace alpenglow {

namespace {

constexpr ImageState READY_TO_SAMPLE{VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                     VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};

VkImageMemoryBarrier2 mip_barrier(GpuImage const& image, std::uint32_t mip, ImageState const& before,
                                  ImageState const& next) {
    VkImageMemoryBarrier2 barrier = image_barrier(image.handle(), image.shape().aspect(), before, next);
    barrier.subresourceRange.baseMipLevel = mip;
    barrier.subresourceRange.levelCount = 1;
    return barrier;
}

VkOffset3D mip_corner(Extent extent, std::uint32_t mip) {
    return {static_cast<std::int32_t>(std::max(extent.width >> mip, 1u)),
            static_cast<std::int32_t>(std::max(extent.height >> mip, 1u)), 1};
}

void record_mip(VkCommandBuffer commands, GpuImage const& image, std::uint32_t mip) {
    record_barriers(commands, {mip_barrier(image, mip - 1, TRANSFER_TARGET, TRANSFER_SOURCE)});
    VkImageBlit blit{};
    blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, 1};
    blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1};
    blit.srcOffsets[1] = mip_corner(image.shape().extent, mip - 1);
    blit.dstOffsets[1] = mip_corner(image.shape().extent, mip);
    vkCmdBlitImage(commands, image.handle(), TRANSFER_SOURCE.layout, image.handle(), TRANSFER_TARGET.layout, 1, &blit,
                   VK_FILTER_LINEAR);
    record_barriers(commands, {mip_barrier(image, mip - 1, TRANSFER_SOURCE, READY_TO_SAMPLE)});
}

VkBufferImageCopy whole_image(ImageShape const& shape) {
    VkBufferImageCopy copy{};
    copy.imageSubresource = {shape.aspect(), 0, 0, shape.layers};
    copy.imageExtent = {shape.extent.width, shape.extent.height, 1};
    return copy;
}

} // namespace

std::uint32_t full_mip_count(Extent extent) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

void upload(Device const& device, GpuBuffer const& target, std::span<std::byte const> bytes) {
    GpuBuffer const staging(device, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferHome::host, "staging");
    std::memcpy(staging.mapped().data(), bytes.data(), bytes.size());
    device.run_once([&](VkCommandBuffer commands) {
        VkBufferCopy const copy{0, 0, bytes.size()};
        vkCmdCopyBuffer(commands, staging.handle(), target.handle(), 1, &copy);
    });
}

void upload(Device const& device, GpuImage& target, std::span<std::byte const> bytes) {
    GpuBuffer const staging(device, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferHome::host, "staging");
    std::memcpy(staging.mapped().data(), bytes.data(), bytes.size());
    device.run_once([&](VkCommandBuffer commands) {
        record_barriers(commands,
                        {image_barrier(target.handle(), target.shape().aspect(), ImageState{}, TRANSFER_TARGET)});
        VkBufferImageCopy const copy = whole_image(target.shape());
        vkCmdCopyBufferToImage(commands, staging.handle(), target.handle(), TRANSFER_TARGET.layout, 1, &copy);
        std::uint32_t const mips = target.shape().mips;
        for (std::uint32_t mip = 1; mip < mips; ++mip) record_mip(commands, target, mip);
        record_barriers(commands, {mip_barrier(target, mips - 1, TRANSFER_TARGET, READY_TO_SAMPLE)});
    });
    target.state = READY_TO_SAMPLE;
}

std::vector<std::byte> read_back(Device const& device, GpuImage& source) {
    ImageShape const& shape = source.shape();
    GpuBuffer const buffer(device, shape.bytes(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferHome::host, "readback");
    device.run_once([&](VkCommandBuffer commands) {
        record_barriers(commands, {image_barrier(source.handle(), shape.aspect(), source.state, TRANSFER_SOURCE)});
        VkBufferImageCopy const copy = whole_image(shape);
        vkCmdCopyImageToBuffer(commands, source.handle(), TRANSFER_SOURCE.layout, buffer.handle(), 1, &copy);
    });
    source.state = TRANSFER_SOURCE;
    std::span<std::byte const> const bytes = buffer.mapped();
    return {bytes.begin(), bytes.end()};
}

} // namespace alpenglow
