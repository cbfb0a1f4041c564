// A Vulkan layer that makes a good device fail as ALPENGLOW_SABOTAGE says:
//   lose_at=N        the N-th submit and everything after it gives VK_ERROR_DEVICE_LOST
//   no_memory_at=N   the N-th allocation gives VK_ERROR_OUT_OF_DEVICE_MEMORY
//   hide_feature     the device says that it has no dynamicRendering
//   old_vulkan       the device says that it knows Vulkan 1.2
// For a program with one instance and one device.

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace {

PFN_vkGetInstanceProcAddr next_instance_function = nullptr;
PFN_vkGetDeviceProcAddr next_device_function = nullptr;
// Looked up when the instance and the device are made: later the loader would answer with this layer's own functions.
PFN_vkCreateDevice next_create_device = nullptr;
PFN_vkGetPhysicalDeviceProperties next_get_properties = nullptr;
PFN_vkGetPhysicalDeviceFeatures2 next_get_features = nullptr;
PFN_vkAllocateMemory next_allocate_memory = nullptr;
PFN_vkQueueSubmit2 next_queue_submit = nullptr;
PFN_vkWaitForFences next_wait_for_fences = nullptr;
PFN_vkDeviceWaitIdle next_wait_idle = nullptr;
int submits = 0, allocations = 0;

std::string plan() {
    char const* const text = std::getenv("ALPENGLOW_SABOTAGE");
    return text ? text : "";
}

/// N of "NAME=N" where that is the plan; 0 otherwise.
int planned_at(std::string const& name) {
    std::string const text = plan();
    return text.starts_with(name + "=") ? std::atoi(text.c_str() + name.size() + 1) : 0;
}

bool device_is_lost() { return planned_at("lose_at") > 0 && submits >= planned_at("lose_at"); }

template <typename Function> void look_up(VkInstance instance, char const* name, Function& function) {
    function = reinterpret_cast<Function>(next_instance_function(instance, name));
}
template <typename Function> void look_up(VkDevice device, char const* name, Function& function) {
    function = reinterpret_cast<Function>(next_device_function(device, name));
}

/// The loader's link to the next layer in a chain of create-info structures.
template <typename Info> Info* find_link(void const* chain, VkStructureType type) {
    for (auto* info = static_cast<Info*>(const_cast<void*>(chain)); info; info = static_cast<Info*>(const_cast<void*>(info->pNext))) {
        if (info->sType == type && info->function == VK_LAYER_LINK_INFO) return info;
    }
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(VkInstanceCreateInfo const* info, VkAllocationCallbacks const* allocator, VkInstance* instance) {
    auto* const link = find_link<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    next_instance_function = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    auto const create = reinterpret_cast<PFN_vkCreateInstance>(next_instance_function(VK_NULL_HANDLE, "vkCreateInstance"));
    VkResult const result = create(info, allocator, instance);
    if (result != VK_SUCCESS) return result;
    look_up(*instance, "vkCreateDevice", next_create_device);
    look_up(*instance, "vkGetPhysicalDeviceProperties", next_get_properties);
    look_up(*instance, "vkGetPhysicalDeviceFeatures2", next_get_features);
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical, VkDeviceCreateInfo const* info, VkAllocationCallbacks const* allocator, VkDevice* device) {
    auto* const link = find_link<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    next_device_function = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    VkResult const result = next_create_device(physical, info, allocator, device);
    if (result != VK_SUCCESS) return result;
    look_up(*device, "vkAllocateMemory", next_allocate_memory);
    look_up(*device, "vkQueueSubmit2", next_queue_submit);
    look_up(*device, "vkWaitForFences", next_wait_for_fences);
    look_up(*device, "vkDeviceWaitIdle", next_wait_idle);
    return result;
}

VKAPI_ATTR void VKAPI_CALL get_properties(VkPhysicalDevice physical, VkPhysicalDeviceProperties* properties) {
    next_get_properties(physical, properties);
    if (plan() == "old_vulkan") properties->apiVersion = VK_API_VERSION_1_2;
}

VKAPI_ATTR void VKAPI_CALL get_features(VkPhysicalDevice physical, VkPhysicalDeviceFeatures2* features) {
    next_get_features(physical, features);
    if (plan() != "hide_feature") return;
    for (auto* part = static_cast<VkBaseOutStructure*>(features->pNext); part; part = part->pNext) {
        if (part->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES) {
            reinterpret_cast<VkPhysicalDeviceVulkan13Features*>(part)->dynamicRendering = VK_FALSE;
        }
    }
}

VKAPI_ATTR VkResult VKAPI_CALL allocate_memory(VkDevice device, VkMemoryAllocateInfo const* info, VkAllocationCallbacks const* allocator, VkDeviceMemory* memory) {
    if (++allocations == planned_at("no_memory_at")) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    return next_allocate_memory(device, info, allocator, memory);
}

VKAPI_ATTR VkResult VKAPI_CALL queue_submit(VkQueue queue, std::uint32_t count, VkSubmitInfo2 const* info, VkFence fence) {
    ++submits;
    if (device_is_lost()) return VK_ERROR_DEVICE_LOST;
    return next_queue_submit(queue, count, info, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL wait_for_fences(VkDevice device, std::uint32_t count, VkFence const* fences, VkBool32 all, std::uint64_t patience) {
    if (device_is_lost()) return VK_ERROR_DEVICE_LOST;
    return next_wait_for_fences(device, count, fences, all, patience);
}

VKAPI_ATTR VkResult VKAPI_CALL wait_idle(VkDevice device) {
    if (device_is_lost()) return VK_ERROR_DEVICE_LOST;
    return next_wait_idle(device);
}

struct Replacement {
    char const* name;
    PFN_vkVoidFunction function;
};

template <typename Function> Replacement replacement(char const* name, Function function) {
    return {name, reinterpret_cast<PFN_vkVoidFunction>(function)};
}

PFN_vkVoidFunction find_replacement(char const* name) {
    static Replacement const replacements[] = {
        replacement("vkCreateInstance", create_instance),
        replacement("vkCreateDevice", create_device),
        replacement("vkGetPhysicalDeviceProperties", get_properties),
        replacement("vkGetPhysicalDeviceFeatures2", get_features),
        replacement("vkAllocateMemory", allocate_memory),
        replacement("vkQueueSubmit2", queue_submit),
        replacement("vkWaitForFences", wait_for_fences),
        replacement("vkDeviceWaitIdle", wait_idle),
    };
    for (Replacement const& entry : replacements) {
        if (std::strcmp(entry.name, name) == 0) return entry.function;
    }
    return nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_device_function(VkDevice device, char const* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(get_device_function);
    PFN_vkVoidFunction const found = find_replacement(name);
    return found || !next_device_function ? found : next_device_function(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_instance_function(VkInstance instance, char const* name) {
    if (std::strcmp(name, "vkGetInstanceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(get_instance_function);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(get_device_function);
    PFN_vkVoidFunction const found = find_replacement(name);
    return found || !next_instance_function ? found : next_instance_function(instance, name);
}

} // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* negotiation) {
    negotiation->loaderLayerInterfaceVersion = 2;
    negotiation->pfnGetInstanceProcAddr = get_instance_function;
    negotiation->pfnGetDeviceProcAddr = get_device_function;
    negotiation->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
