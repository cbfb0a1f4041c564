#include "gpu/image.h"

namespace alpenglow {

GpuImage::GpuImage(Device const& device, ImageShape const& shape, VkImageUsageFlags usage, std::string const& name)
    : device_(device), shape_(shape), usage_(usage) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = shape.format;
    info.extent = {shape.extent.width, shape.extent.height, 1};
    info.mipLevels = shape.mips;
    info.arrayLayers = shape.layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    check(vkCreateImage(device.handle(), &info, nullptr, &image_), "making the image " + name);
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device.handle(), image_, &needs);
    try {
        memory_ = device.allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    } catch (...) {
        vkDestroyImage(device.handle(), image_, nullptr);
        throw;
    }
    bytes_ = needs.size;
    check(vkBindImageMemory(device.handle(), image_, memory_, 0), "binding the image " + name);
    device.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image_), name);
    make_views();
}

GpuImage::GpuImage(Device const& device, VkImage borrowed, ImageShape const& shape, VkImageUsageFlags usage,
                   std::string const& name)
    : device_(device), shape_(shape), usage_(usage), image_(borrowed) {
    device.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image_), name);
    make_views();
}

void GpuImage::make_views() {
    constexpr VkImageUsageFlags viewed = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                         VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                         VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    if (!(usage_ & viewed)) return;
    array_view_ = make_view(VK_IMAGE_VIEW_TYPE_2D_ARRAY, 0, shape_.layers);
    view_ = shape_.layers > 1 ? array_view_ : make_view(VK_IMAGE_VIEW_TYPE_2D, 0, 1);
    for (std::uint32_t i = 0; i < shape_.layers; ++i) layer_views_.push_back(make_view(VK_IMAGE_VIEW_TYPE_2D, i, 1));
}

GpuImage::~GpuImage() {
    for (VkImageView view : layer_views_) vkDestroyImageView(device_.handle(), view, nullptr);
    if (view_ != array_view_) vkDestroyImageView(device_.handle(), view_, nullptr);
    vkDestroyImageView(device_.handle(), array_view_, nullptr);
    if (!memory_) return;
    vkDestroyImage(device_.handle(), image_, nullptr);
    device_.free(memory_, bytes_);
}

VkImageView GpuImage::make_view(VkImageViewType type, std::uint32_t first_layer, std::uint32_t layers) const {
    VkImageViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.image = image_;
    info.viewType = type;
    info.format = shape_.format;
    info.subresourceRange = {shape_.aspect(), 0, shape_.mips, first_layer, layers};
    VkImageView view = VK_NULL_HANDLE;
    check(vkCreateImageView(device_.handle(), &info, nullptr, &view), "making an image view");
    return view;
}

VkImageMemoryBarrier2 image_barrier(VkImage image, VkImageAspectFlags aspect, ImageState const& before,
                                    ImageState const& next) {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = before.stages;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = next.stages;
    barrier.dstAccessMask = next.access;
    barrier.oldLayout = before.layout;
    barrier.newLayout = next.layout;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
    return barrier;
}

void record_barriers(VkCommandBuffer commands, std::vector<VkImageMemoryBarrier2> const& barriers) {
    if (barriers.empty()) return;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = static_cast<std::uint32_t>(barriers.size());
    dependency.pImageMemoryBarriers = barriers.data();
    vkCmdPipelineBarrier2(commands, &dependency);
}

} // namespace alpenglow
