#pragma once

#include "core/extent.h"
#include "gpu/device.h"

#include <string>

namespace alpenglow {

struct ImageShape {
    VkFormat format = VK_FORMAT_UNDEFINED;
    Extent extent;
    std::uint32_t layers = 1;
    std::uint32_t mips = 1;

    bool operator==(ImageShape const&) const = default;
    bool is_depth() const { return format == VK_FORMAT_D32_SFLOAT; }
    VkImageAspectFlags aspect() const { return is_depth() ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT; }
    std::size_t bytes() const { return extent.pixels() * layers * bytes_per_texel(format); } ///< of mip 0
};

/// How an image was touched last: what the next barrier has to wait for.
struct ImageState {
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;

    bool operator==(ImageState const&) const = default;
};

/// A 2-D image (or array of them) in device memory, with one view of the whole and one for each layer.
class GpuImage {
public:
    GpuImage(Device const& device, ImageShape const& shape, VkImageUsageFlags usage, std::string const& name);
    /// Views of an image that somebody else owns, such as a window's swapchain.
    GpuImage(Device const& device, VkImage borrowed, ImageShape const& shape, VkImageUsageFlags usage,
             std::string const& name);
    ~GpuImage();
    GpuImage(GpuImage const&) = delete;
    GpuImage& operator=(GpuImage const&) = delete;

    VkImage handle() const { return image_; }
    ImageShape const& shape() const { return shape_; }
    VkImageUsageFlags usage() const { return usage_; }
    /// 2-D where there is one layer, 2-D array where there are several.
    VkImageView view() const { return view_; }
    /// Always a 2-D array.
    VkImageView array_view() const { return array_view_; }
    VkImageView layer_view(std::uint32_t layer) const { return layer_views_.at(layer); }

    ImageState state; ///< kept by whoever records commands for the image

private:
    void make_views();
    VkImageView make_view(VkImageViewType type, std::uint32_t first_layer, std::uint32_t layers) const;

    Device const& device_;
    ImageShape shape_;
    VkImageUsageFlags usage_;
    VkImage image_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE; ///< none: the image is borrowed
    VkDeviceSize bytes_ = 0;
    VkImageView view_ = VK_NULL_HANDLE, array_view_ = VK_NULL_HANDLE;
    std::vector<VkImageView> layer_views_;
};

/// One barrier for the whole image, from its state to `next`.
VkImageMemoryBarrier2 image_barrier(VkImage image, VkImageAspectFlags aspect, ImageState const& before,
                                    ImageState const& next);
void record_barriers(VkCommandBuffer commands, std::vector<VkImageMemoryBarrier2> const& barriers);

/// States that uploads and readbacks pass through.
inline constexpr ImageState TRANSFER_SOURCE{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                            VK_ACCESS_2_TRANSFER_READ_BIT};
inline constexpr ImageState TRANSFER_TARGET{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                            VK_ACCESS_2_TRANSFER_WRITE_BIT};

} // namespace alpenglow
