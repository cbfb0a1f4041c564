#include "gpu/abilities.h"

#include <algorithm>
#include <array>

namespace alpenglow {

namespace {

struct FormatNeed {
    VkFormat format;
    VkFormatFeatureFlags features;
    char const* text;
};

constexpr VkFormatFeatureFlags SAMPLED = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
constexpr VkFormatFeatureFlags FILTERED = SAMPLED | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
constexpr VkFormatFeatureFlags COLOR = VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT | SAMPLED;
constexpr VkFormatFeatureFlags BLIT = VK_FORMAT_FEATURE_BLIT_SRC_BIT | VK_FORMAT_FEATURE_BLIT_DST_BIT;

constexpr std::array FORMAT_NEEDS = {
    FormatNeed{VK_FORMAT_R32G32B32A32_SFLOAT, FILTERED | VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT,
               "32-bit float tables with linear filtering"},
    FormatNeed{VK_FORMAT_R32G32_SFLOAT, FILTERED | VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT,
               "32-bit float pairs with linear filtering"},
    FormatNeed{VK_FORMAT_R16G16B16A16_SNORM, COLOR, "16-bit signed normals as an attachment"},
    FormatNeed{VK_FORMAT_B10G11R11_UFLOAT_PACK32, COLOR, "packed-float emission as an attachment"},
    FormatNeed{VK_FORMAT_R8G8B8A8_SRGB, COLOR | FILTERED | BLIT, "sRGB colour"},
    FormatNeed{VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | COLOR | FILTERED | BLIT,
               "8-bit images for storage and as attachments"},
    FormatNeed{VK_FORMAT_R16G16B16A16_UNORM, FILTERED | BLIT, "16-bit pictures with linear filtering"},
    FormatNeed{VK_FORMAT_D32_SFLOAT, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | SAMPLED, "32-bit float depth"},
};

template <typename List> void note(List& lacks, bool present, char const* name) {
    if (!present) lacks.emplace_back(name);
}

} // namespace

std::vector<std::string> missing_abilities(DeviceAbilities const& abilities, bool window) {
    std::vector<std::string> lacks;
    note(lacks, abilities.api_version >= VK_API_VERSION_1_3, "Vulkan 1.3");
    note(lacks, abilities.graphics_queue, "a queue for graphics and compute with timestamps");
    note(lacks, abilities.vulkan13.dynamicRendering, "dynamicRendering");
    note(lacks, abilities.vulkan13.synchronization2, "synchronization2");
    note(lacks, abilities.vulkan13.maintenance4, "maintenance4");
    note(lacks, abilities.vulkan12.scalarBlockLayout, "scalarBlockLayout");
    note(lacks, abilities.features.features.depthClamp, "depthClamp");
    note(lacks, abilities.features.features.shaderStorageImageExtendedFormats, "shaderStorageImageExtendedFormats");
    note(lacks, abilities.subgroup_votes, "subgroup votes in compute shaders");
    auto const has = [&](char const* name) {
        return std::ranges::find(abilities.extensions, name) != abilities.extensions.end();
    };
    note(lacks, has(VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME), VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME);
    if (window) {
        note(lacks, has(VK_KHR_SWAPCHAIN_EXTENSION_NAME), VK_KHR_SWAPCHAIN_EXTENSION_NAME);
        note(lacks, abilities.presents, "presentation to the window");
    }
    lacks.insert(lacks.end(), abilities.missing_formats.begin(), abilities.missing_formats.end());
    return lacks;
}

std::optional<std::uint32_t> find_queue_family(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags need = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & need) == need && families[i].timestampValidBits > 0) return i;
    }
    return {};
}

bool has_subgroup_votes(VkPhysicalDevice device) {
    VkPhysicalDeviceVulkan11Properties subgroups{};
    subgroups.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &subgroups;
    vkGetPhysicalDeviceProperties2(device, &properties);
    return (subgroups.subgroupSupportedOperations & VK_SUBGROUP_FEATURE_VOTE_BIT) != 0 &&
           (subgroups.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0;
}

DeviceAbilities read_abilities(VkPhysicalDevice device, VkSurfaceKHR surface) {
    DeviceAbilities abilities;
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    abilities.api_version = properties.apiVersion;
    if (properties.apiVersion >= VK_API_VERSION_1_3) {
        abilities.vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
        abilities.vulkan12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
        abilities.vulkan12.pNext = &abilities.vulkan13;
        abilities.features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
        abilities.features.pNext = &abilities.vulkan12;
        vkGetPhysicalDeviceFeatures2(device, &abilities.features);
        abilities.subgroup_votes = has_subgroup_votes(device);
    }
    abilities.features.pNext = abilities.vulkan12.pNext = abilities.vulkan13.pNext = nullptr;

    std::uint32_t count = 0;
    check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr), "listing device extensions");
    std::vector<VkExtensionProperties> extensions(count);
    check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data()),
          "listing device extensions");
    for (VkExtensionProperties const& extension : extensions)
        abilities.extensions.emplace_back(extension.extensionName);

    for (FormatNeed const& need : FORMAT_NEEDS) {
        VkFormatProperties format{};
        vkGetPhysicalDeviceFormatProperties(device, need.format, &format);
        if ((format.optimalTilingFeatures & need.features) != need.features)
            abilities.missing_formats.emplace_back(need.text);
    }
    std::optional<std::uint32_t> const family = find_queue_family(device);
    abilities.graphics_queue = family.has_value();
    if (surface && family) {
        VkBool32 presents = VK_FALSE;
        check(vkGetPhysicalDeviceSurfaceSupportKHR(device, *family, surface, &presents), "asking for presentation");
        abilities.presents = presents;
    }
    return abilities;
}

DeviceReport report_device(VkPhysicalDevice device, int index, VkSurfaceKHR surface) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(device, &properties);

    DeviceReport report;
    report.index = index;
    report.name = properties.properties.deviceName;
    report.driver = std::string(driver.driverName) + " " + driver.driverInfo;
    switch (properties.properties.deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        report.type = "discrete GPU", report.preference = 4;
        break;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        report.type = "integrated GPU", report.preference = 3;
        break;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        report.type = "virtual GPU", report.preference = 2;
        break;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        report.type = "software", report.preference = 1;
        break;
    default:
        report.type = "other";
        break;
    }
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(device, &memory);
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
        if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            report.memory_bytes += memory.memoryHeaps[i].size;
    }
    report.lacks = missing_abilities(read_abilities(device, surface), surface != VK_NULL_HANDLE);
    return report;
}

} // namespace alpenglow
