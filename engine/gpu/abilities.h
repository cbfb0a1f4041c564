#pragma once

#include "gpu/device.h"

#include <optional>

namespace alpenglow {

/// The first family that does graphics, compute and timestamps.
std::optional<std::uint32_t> find_queue_family(VkPhysicalDevice device);
/// `surface` may be VK_NULL_HANDLE: headless.
DeviceAbilities read_abilities(VkPhysicalDevice device, VkSurfaceKHR surface);
DeviceReport report_device(VkPhysicalDevice device, int index, VkSurfaceKHR surface);

} // namespace alpenglow
