#pragma once

#include "gpu/image.h"

#include <memory>
#include <optional>

namespace alpenglow {

/// The images of the device's surface. Pictures are shown in the order drawn, one at each refresh of the screen (FIFO,
/// which every device has). Throws Error(device) where the surface is lost.
class Swapchain {
public:
    /// `framebuffer`: the window's size in pixels, not in the window system's units. Empty (a minimized window) is
    /// allowed.
    Swapchain(Device const& device, Extent framebuffer, std::uint32_t frames_in_flight);
    ~Swapchain();
    Swapchain(Swapchain const&) = delete;
    Swapchain& operator=(Swapchain const&) = delete;

    /// Makes the images anew, after waiting for the device.
    void resize(Extent framebuffer);
    /// Of the images: the surface decides it where it has a size of its own. Empty: there is nothing to draw to now.
    Extent extent() const { return extent_; }
    /// The device encodes what is written as sRGB by itself.
    bool encodes_srgb() const;

    struct Target {
        GpuImage* image;
        VkSemaphore acquired; ///< the frame waits for it
        VkSemaphore finished; ///< the frame signals it
    };
    /// The image to draw next; nothing where there is none, or where the surface has changed: call `resize`.
    std::optional<Target> acquire();
    /// Shows the image acquired last. False where the surface has changed: call `resize`.
    bool present();

private:
    void make(Extent framebuffer);
    void make_images();
    void destroy_images();
    VkSemaphore make_semaphore() const;

    Device const& device_;
    VkSurfaceFormatKHR format_{};
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    Extent extent_;
    std::vector<std::unique_ptr<GpuImage>> images_;
    std::vector<VkSemaphore> finished_; ///< one for each image: free again when the image comes back
    std::vector<VkSemaphore> acquired_; ///< taken in turn
    std::size_t next_acquired_ = 0;
    std::uint32_t image_ = 0; ///< acquired last
};

} // namespace alpenglow
