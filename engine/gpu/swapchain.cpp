#include "gpu/swapchain.h"

#include "core/error.h"

#include <algorithm>
#include <array>

namespace alpenglow {

namespace {

constexpr std::uint64_t PATIENCE_NS = 10'000'000'000;

/// Pictures are encoded already, so that formats without an encoding of their own come first.
constexpr std::array WANTED = {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_B8G8R8A8_SRGB,
                               VK_FORMAT_R8G8B8A8_SRGB};

VkSurfaceFormatKHR choose_format(Device const& device) {
    std::uint32_t count = 0;
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), device.surface(), &count, nullptr),
          "listing the window's formats");
    std::vector<VkSurfaceFormatKHR> formats(count);
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), device.surface(), &count, formats.data()),
          "listing the window's formats");
    for (VkFormat wanted : WANTED) {
        for (VkSurfaceFormatKHR const& format : formats) {
            if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) return format;
        }
    }
    throw Error(ErrorKind::device, "the window takes no 8-bit sRGB pictures", device.name(), "use --headless");
}

/// Surfaces of some window systems take whatever size their swapchain has; they say so by this width.
constexpr std::uint32_t ANY_SIZE = 0xFFFFFFFF;

Extent surface_extent(VkSurfaceCapabilitiesKHR const& surface, Extent framebuffer) {
    if (surface.currentExtent.width != ANY_SIZE) return {surface.currentExtent.width, surface.currentExtent.height};
    return {std::clamp(framebuffer.width, surface.minImageExtent.width, surface.maxImageExtent.width),
            std::clamp(framebuffer.height, surface.minImageExtent.height, surface.maxImageExtent.height)};
}

/// One more than the least, so that the next frame need not wait for the one on the screen.
std::uint32_t image_count(VkSurfaceCapabilitiesKHR const& surface) {
    std::uint32_t const wanted = surface.minImageCount + 1;
    return surface.maxImageCount > 0 ? std::min(wanted, surface.maxImageCount) : wanted;
}

VkCompositeAlphaFlagBitsKHR choose_alpha(VkSurfaceCapabilitiesKHR const& surface) {
    auto const opaque = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
    return surface.supportedCompositeAlpha & opaque ? opaque : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
}

} // namespace

Swapchain::Swapchain(Device const& device, Extent framebuffer, std::uint32_t frames_in_flight)
    : device_(device), format_(choose_format(device)) {
    // One more than frames in flight: an image is acquired before the oldest frame is waited for.
    for (std::uint32_t i = 0; i <= frames_in_flight; ++i) acquired_.push_back(make_semaphore());
    make(framebuffer);
}

Swapchain::~Swapchain() {
    vkDeviceWaitIdle(device_.handle());
    destroy_images();
    vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
    for (VkSemaphore semaphore : acquired_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
}

bool Swapchain::encodes_srgb() const {
    return format_.format == VK_FORMAT_B8G8R8A8_SRGB || format_.format == VK_FORMAT_R8G8B8A8_SRGB;
}

void Swapchain::resize(Extent framebuffer) {
    device_.wait_idle();
    make(framebuffer);
}

void Swapchain::make(Extent framebuffer) {
    VkSurfaceCapabilitiesKHR surface{};
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), device_.surface(), &surface),
          "asking for the window's size");
    destroy_images();
    extent_ = framebuffer.pixels() > 0 ? surface_extent(surface, framebuffer) : Extent{};
    if (extent_.pixels() == 0) return;

    VkSwapchainCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
    info.surface = device_.surface();
    info.minImageCount = image_count(surface);
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = {extent_.width, extent_.height};
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    info.preTransform = surface.currentTransform;
    info.compositeAlpha = choose_alpha(surface);
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    info.oldSwapchain = swapchain_;
    VkSwapchainKHR swapchain = VK_NULL_HANDLE;
    VkResult const result = vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &swapchain);
    vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
    swapchain_ = swapchain;
    check(result, "making the window's images");
    make_images();
}

void Swapchain::make_images() {
    std::uint32_t count = 0;
    check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, nullptr), "listing the window's images");
    std::vector<VkImage> images(count);
    check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, images.data()), "listing the window's images");
    for (VkImage image : images) {
        images_.push_back(std::make_unique<GpuImage>(device_, image, ImageShape{format_.format, extent_},
                                                     VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "window"));
        finished_.push_back(make_semaphore());
    }
}

void Swapchain::destroy_images() {
    images_.clear();
    for (VkSemaphore semaphore : finished_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
    finished_.clear();
}

VkSemaphore Swapchain::make_semaphore() const {
    VkSemaphoreCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    VkSemaphore semaphore = VK_NULL_HANDLE;
    check(vkCreateSemaphore(device_.handle(), &info, nullptr, &semaphore), "making a semaphore");
    return semaphore;
}

std::optional<Swapchain::Target> Swapchain::acquire() {
    if (images_.empty()) return {};
    VkSemaphore const acquired = acquired_[next_acquired_];
    VkResult const result =
        vkAcquireNextImageKHR(device_.handle(), swapchain_, PATIENCE_NS, acquired, VK_NULL_HANDLE, &image_);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_TIMEOUT) return {};
    check(result, "waiting for the window");
    next_acquired_ = (next_acquired_ + 1) % acquired_.size();
    // Its first barrier has to come behind the wait for `acquired`, which a barrier without stages would not do.
    images_[image_]->state = {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                              VK_ACCESS_2_NONE};
    return Target{images_[image_].get(), acquired, finished_[image_]};
}

bool Swapchain::present() {
    VkPresentInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &finished_[image_];
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain_;
    info.pImageIndices = &image_;
    VkResult const result = vkQueuePresentKHR(device_.queue(), &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return false;
    check(result, "showing a picture");
    return true;
}

} // namespace alpenglow
