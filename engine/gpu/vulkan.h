#pragma once

#include <cstdint>
#include <string_view>
#include <vulkan/vulkan.h>

namespace alpenglow {

/// Throws Error(device) where `result` is an error: what was tried, Vulkan's name for the failure, and what to do.
void check(VkResult result, std::string_view doing);
std::string_view result_name(VkResult result);

/// Bytes of a texel; 0 for a format that Alpenglow does not use.
std::uint32_t bytes_per_texel(VkFormat format);

} // namespace alpenglow
