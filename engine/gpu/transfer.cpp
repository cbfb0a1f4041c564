#include "gpu/transfer.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace alpenglow {

namespace {

constexpr ImageState READY_TO_SAMPLE{VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                     VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};

VkBufferImageCopy mip_copy(ImageShape const& shape, std::uint32_t mip, VkDeviceSize offset) {
    VkBufferImageCopy copy{};
    copy.bufferOffset = offset;
    copy.imageSubresource = {shape.aspect(), mip, 0, shape.layers};
    copy.imageExtent = {std::max(shape.extent.width >> mip, 1u), std::max(shape.extent.height >> mip, 1u), 1};
    return copy;
}

} // namespace

std::uint32_t full_mip_count(Extent extent) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

GpuBuffer const& Staging::buffer(VkDeviceSize bytes) {
    if (buffer_ && buffer_->bytes() >= bytes) return *buffer_;
    buffer_.reset();
    buffer_ =
        std::make_unique<GpuBuffer>(device_, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferHome::host, "staging");
    return *buffer_;
}

void upload(Staging& staging, GpuBuffer const& target, std::span<std::byte const> bytes) {
    GpuBuffer const& source = staging.buffer(bytes.size());
    std::memcpy(source.mapped().data(), bytes.data(), bytes.size());
    staging.device().run_once([&](VkCommandBuffer commands) {
        VkBufferCopy const copy{0, 0, bytes.size()};
        vkCmdCopyBuffer(commands, source.handle(), target.handle(), 1, &copy);
    });
}

void upload(Staging& staging, GpuImage& target, std::span<std::span<std::byte const> const> mips) {
    assert(mips.size() == target.shape().mips);
    std::size_t bytes = 0;
    for (std::span<std::byte const> const mip : mips) bytes += mip.size();
    GpuBuffer const& source = staging.buffer(bytes);
    std::vector<VkBufferImageCopy> copies;
    std::size_t offset = 0;
    for (std::span<std::byte const> const mip : mips) {
        std::memcpy(source.mapped().data() + offset, mip.data(), mip.size());
        copies.push_back(mip_copy(target.shape(), static_cast<std::uint32_t>(copies.size()), offset));
        offset += mip.size();
    }
    staging.device().run_once([&](VkCommandBuffer commands) {
        VkImageAspectFlags const aspect = target.shape().aspect();
        record_barriers(commands, {image_barrier(target.handle(), aspect, ImageState{}, TRANSFER_TARGET)});
        vkCmdCopyBufferToImage(commands, source.handle(), target.handle(), TRANSFER_TARGET.layout,
                               static_cast<std::uint32_t>(copies.size()), copies.data());
        record_barriers(commands, {image_barrier(target.handle(), aspect, TRANSFER_TARGET, READY_TO_SAMPLE)});
    });
    target.state = READY_TO_SAMPLE;
}

void upload(Device const& device, GpuImage& target, std::span<std::byte const> bytes) {
    Staging staging(device);
    upload(staging, target, std::span(&bytes, 1));
}

std::vector<std::byte> read_back(Device const& device, GpuImage& source) {
    ImageShape const& shape = source.shape();
    GpuBuffer const buffer(device, shape.bytes(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferHome::host, "readback");
    device.run_once([&](VkCommandBuffer commands) {
        record_barriers(commands, {image_barrier(source.handle(), shape.aspect(), source.state, TRANSFER_SOURCE)});
        VkBufferImageCopy const copy = mip_copy(shape, 0, 0);
        vkCmdCopyImageToBuffer(commands, source.handle(), TRANSFER_SOURCE.layout, buffer.handle(), 1, &copy);
    });
    source.state = TRANSFER_SOURCE;
    std::span<std::byte const> const bytes = buffer.mapped();
    return {bytes.begin(), bytes.end()};
}

} // namespace alpenglow
