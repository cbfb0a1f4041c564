#pragma once

#include "gpu/vulkan.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace alpenglow {

struct DeviceOptions {
    std::optional<int> index{};                  ///< as `list_devices` counts; nothing: the best one
    bool validation = false;                     ///< core and synchronization validation, where the layer is installed
    std::vector<char const*> instance_extensions{}; ///< what the window system asks for
    /// Makes the window's surface; the device must be able to present to it. Empty: headless.
    std::function<VkSurfaceKHR(VkInstance)> make_surface{};
};

/// A device of this machine, and whether Alpenglow can run on it.
struct DeviceReport {
    int index = 0;
    std::string name, driver, type;
    std::uint64_t memory_bytes = 0;              ///< of its device-local heaps
    std::vector<std::string> lacks;              ///< why it is refused; empty: usable
    int preference = 0;                          ///< the highest is chosen
};

/// What a physical device can do, as plain data, so that the verdict is a pure function.
struct DeviceAbilities {
    std::uint32_t api_version = 0;
    VkPhysicalDeviceFeatures2 features{};
    VkPhysicalDeviceVulkan12Features vulkan12{};
    VkPhysicalDeviceVulkan13Features vulkan13{};
    std::vector<std::string> extensions;
    std::vector<std::string> missing_formats;    ///< "FORMAT can't be USED" for each that is needed
    bool graphics_queue = false;
    bool subgroup_votes = false; ///< in compute shaders
    bool presents = true;
};

/// Each thing that Alpenglow needs and the device lacks, by name.
std::vector<std::string> missing_abilities(DeviceAbilities const& abilities, bool window);

/// Throws Error(device) where Vulkan itself is not there.
std::vector<DeviceReport> list_devices();

/// Texts that any thread may add to.
class MessageList {
public:
    void add(std::string text);
    std::vector<std::string> all() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> texts_;
};

/// Instance, physical and logical device, its one queue, and what validation said. Programs have one, and at most another for a
/// Rehearsal.
class Device {
public:
    explicit Device(DeviceOptions const& options = {});
    ~Device();
    Device(Device const&) = delete;
    Device& operator=(Device const&) = delete;

    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physical() const { return physical_; }
    VkDevice handle() const { return device_; }
    VkQueue queue() const { return queue_; }
    std::uint32_t queue_family() const { return queue_family_; }
    VkSurfaceKHR surface() const { return surface_; }
    VkPhysicalDeviceLimits const& limits() const { return properties_.limits; }
    int index() const { return index_; } ///< as `list_devices` counts
    std::string name() const { return properties_.deviceName; }
    std::string driver() const { return driver_; }
    bool is_software() const { return properties_.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }
    PFN_vkCmdPushDescriptorSetKHR push_descriptors() const { return push_descriptors_; }

    /// Names an object in validation messages and captures; does nothing without validation.
    void set_name(VkObjectType type, std::uint64_t handle, std::string const& name) const;
    void begin_label(VkCommandBuffer commands, char const* name) const;
    void end_label(VkCommandBuffer commands) const;

    VkDeviceMemory allocate(VkMemoryRequirements const& needs, VkMemoryPropertyFlags flags) const;
    void free(VkDeviceMemory memory, VkDeviceSize bytes) const;
    /// Bytes of device memory in use now, and the most there ever were.
    std::uint64_t memory_in_use() const { return memory_in_use_; }
    std::uint64_t peak_memory() const { return peak_memory_; }

    /// Runs commands once and waits for them.
    void run_once(std::function<void(VkCommandBuffer)> const& record) const;
    void wait_idle() const;

    /// Validation messages since the start, of all threads; tests fail on any.
    std::vector<std::string> messages() const { return messages_.all(); }

private:
    void make_instance(DeviceOptions const& options);
    void choose_physical(DeviceOptions const& options);
    void make_device(bool window);
    void destroy() noexcept;

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    int index_ = 0;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    std::string driver_;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    std::uint32_t queue_family_ = 0;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    PFN_vkCmdPushDescriptorSetKHR push_descriptors_ = nullptr;
    PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
    MessageList messages_;
    mutable std::atomic<std::uint64_t> memory_in_use_ = 0, peak_memory_ = 0;
};

} // namespace alpenglow
