#include "gpu/device.h"

#include "core/error.h"
#include "core/log.h"
#include "gpu/abilities.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

namespace alpenglow {

namespace {

constexpr char const* VALIDATION_LAYER = "VK_LAYER_KHRONOS_validation";

bool has_validation_layer() {
    std::uint32_t count = 0;
    check(vkEnumerateInstanceLayerProperties(&count, nullptr), "listing Vulkan layers");
    std::vector<VkLayerProperties> layers(count);
    check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "listing Vulkan layers");
    return std::ranges::any_of(layers,
                               [](auto const& layer) { return std::strcmp(layer.layerName, VALIDATION_LAYER) == 0; });
}

VKAPI_ATTR VkBool32 VKAPI_CALL receive_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                               VkDebugUtilsMessengerCallbackDataEXT const* data, void* user) {
    static_cast<MessageList*>(user)->add(data->pMessage);
    log_warning(data->pMessage);
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messenger_info(MessageList& messages) {
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = receive_message;
    info.pUserData = &messages;
    return info;
}

VkInstance make_plain_instance(std::vector<char const*> const& layers, std::vector<char const*> const& extensions,
                               void const* next) {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "alpenglow";
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pNext = next;
    info.pApplicationInfo = &application;
    info.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    VkInstance instance = VK_NULL_HANDLE;
    check(vkCreateInstance(&info, nullptr, &instance), "starting Vulkan");
    return instance;
}

std::vector<VkPhysicalDevice> physical_devices(VkInstance instance) {
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "listing devices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance, &count, devices.data()), "listing devices");
    devices.resize(count);
    return devices;
}

std::string joined(std::vector<std::string> const& parts) { return fmt::format("{}", fmt::join(parts, ", ")); }

template <typename Function> Function instance_function(VkInstance instance, char const* name) {
    return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
}

} // namespace

std::vector<DeviceReport> list_devices() {
    VkInstance const instance = make_plain_instance({}, {}, nullptr);
    std::vector<DeviceReport> reports;
    for (VkPhysicalDevice device : physical_devices(instance)) {
        reports.push_back(report_device(device, static_cast<int>(reports.size()), VK_NULL_HANDLE));
    }
    vkDestroyInstance(instance, nullptr);
    return reports;
}

void MessageList::add(std::string text) {
    std::lock_guard const lock(mutex_);
    texts_.push_back(std::move(text));
}

std::vector<std::string> MessageList::all() const {
    std::lock_guard const lock(mutex_);
    return texts_;
}

Device::Device(DeviceOptions const& options) {
    try {
        make_instance(options);
        if (options.make_surface) surface_ = options.make_surface(instance_);
        choose_physical(options);
        make_device(surface_ != VK_NULL_HANDLE);
    } catch (...) {
        destroy();
        throw;
    }
}

Device::~Device() { destroy(); }

void Device::destroy() noexcept {
    if (device_) {
        vkDeviceWaitIdle(device_);
        vkDestroyCommandPool(device_, pool_, nullptr);
        vkDestroyDevice(device_, nullptr);
    }
    if (surface_) vkDestroySurfaceKHR(instance_, surface_, nullptr);
    if (messenger_) {
        instance_function<PFN_vkDestroyDebugUtilsMessengerEXT>(instance_, "vkDestroyDebugUtilsMessengerEXT")(
            instance_, messenger_, nullptr);
    }
    if (instance_) vkDestroyInstance(instance_, nullptr);
}

void Device::make_instance(DeviceOptions const& options) {
    std::vector<char const*> layers, extensions = options.instance_extensions;
    bool const validate = options.validation && has_validation_layer();
    if (options.validation && !validate)
        log_warning("validation was asked for, but the layer VK_LAYER_KHRONOS_validation is not installed");
    if (!validate) {
        instance_ = make_plain_instance(layers, extensions, nullptr);
        return;
    }
    layers.push_back(VALIDATION_LAYER);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    VkDebugUtilsMessengerCreateInfoEXT const messenger = messenger_info(messages_);
    VkValidationFeatureEnableEXT const enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.pNext = &messenger;
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = enabled;
    instance_ = make_plain_instance(layers, extensions, &features);
    auto const create =
        instance_function<PFN_vkCreateDebugUtilsMessengerEXT>(instance_, "vkCreateDebugUtilsMessengerEXT");
    check(create(instance_, &messenger, nullptr, &messenger_), "starting validation");
    set_name_ = instance_function<PFN_vkSetDebugUtilsObjectNameEXT>(instance_, "vkSetDebugUtilsObjectNameEXT");
    begin_label_ = instance_function<PFN_vkCmdBeginDebugUtilsLabelEXT>(instance_, "vkCmdBeginDebugUtilsLabelEXT");
    end_label_ = instance_function<PFN_vkCmdEndDebugUtilsLabelEXT>(instance_, "vkCmdEndDebugUtilsLabelEXT");
}

void Device::choose_physical(DeviceOptions const& options) {
    std::vector<VkPhysicalDevice> const devices = physical_devices(instance_);
    std::vector<DeviceReport> reports;
    for (VkPhysicalDevice device : devices)
        reports.push_back(report_device(device, static_cast<int>(reports.size()), surface_));
    auto const advice = "see `alpenglow devices`; mesa-vulkan-drivers has one that needs no GPU";
    if (options.index && (*options.index < 0 || *options.index >= static_cast<int>(devices.size()))) {
        throw Error(ErrorKind::device,
                    fmt::format("there is no device {}; this machine has {}", *options.index, devices.size()),
                    "--device", advice);
    }
    DeviceReport const* best = nullptr;
    std::string refused;
    for (DeviceReport const& report : reports) {
        if (options.index && report.index != *options.index) continue;
        if (!report.lacks.empty())
            refused += fmt::format("; {} lacks {}", report.name, joined(report.lacks));
        else if (!best || report.preference > best->preference)
            best = &report;
    }
    if (!best) throw Error(ErrorKind::device, "no Vulkan device can be used" + refused, {}, advice);
    physical_ = devices[static_cast<std::size_t>(best->index)];
    index_ = best->index;
    driver_ = best->driver;
    vkGetPhysicalDeviceProperties(physical_, &properties_);
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
    queue_family_ = *find_queue_family(physical_);
}

void Device::make_device(bool window) {
    float const priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = queue_family_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;

    VkPhysicalDeviceVulkan13Features vulkan13{};
    vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    vulkan13.dynamicRendering = vulkan13.synchronization2 = vulkan13.maintenance4 = VK_TRUE;
    VkPhysicalDeviceVulkan12Features vulkan12{};
    vulkan12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    vulkan12.pNext = &vulkan13;
    vulkan12.scalarBlockLayout = VK_TRUE;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &vulkan12;
    features.features.depthClamp = features.features.shaderStorageImageExtendedFormats = VK_TRUE;

    std::vector<char const*> extensions = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
    if (window) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    check(vkCreateDevice(physical_, &info, nullptr, &device_), "starting the device " + name());
    vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
    push_descriptors_ =
        reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(vkGetDeviceProcAddr(device_, "vkCmdPushDescriptorSetKHR"));

    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = queue_family_;
    check(vkCreateCommandPool(device_, &pool, nullptr, &pool_), "making a command pool");
}

void Device::set_name(VkObjectType type, std::uint64_t handle, std::string const& name) const {
    if (!set_name_) return;
    VkDebugUtilsObjectNameInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = name.c_str();
    check(set_name_(device_, &info), "naming an object");
}

void Device::begin_label(VkCommandBuffer commands, char const* name) const {
    if (!begin_label_) return;
    VkDebugUtilsLabelEXT label{};
    label.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
    label.pLabelName = name;
    begin_label_(commands, &label);
}

void Device::end_label(VkCommandBuffer commands) const {
    if (end_label_) end_label_(commands);
}

VkDeviceMemory Device::allocate(VkMemoryRequirements const& needs, VkMemoryPropertyFlags flags) const {
    for (std::uint32_t type = 0; type < memory_.memoryTypeCount; ++type) {
        bool const allowed = (needs.memoryTypeBits >> type) & 1u;
        if (!allowed || (memory_.memoryTypes[type].propertyFlags & flags) != flags) continue;
        VkMemoryAllocateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        info.allocationSize = needs.size;
        info.memoryTypeIndex = type;
        VkDeviceMemory memory = VK_NULL_HANDLE;
        check(vkAllocateMemory(device_, &info, nullptr, &memory),
              fmt::format("allocating {} MiB of device memory", needs.size >> 20));
        std::uint64_t const now = memory_in_use_ += needs.size;
        if (now > peak_memory_) peak_memory_ = now;
        return memory;
    }
    throw Error(ErrorKind::device, "no memory of the kind that is needed", name());
}

void Device::free(VkDeviceMemory memory, VkDeviceSize bytes) const {
    vkFreeMemory(device_, memory, nullptr);
    memory_in_use_ -= bytes;
}

void Device::run_once(std::function<void(VkCommandBuffer)> const& record) const {
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = pool_;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device_, &allocate, &commands), "making a command buffer");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands, &begin), "recording commands");
    record(commands);
    check(vkEndCommandBuffer(commands), "recording commands");
    VkCommandBufferSubmitInfo buffer{};
    buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    buffer.commandBuffer = commands;
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &buffer;
    check(vkQueueSubmit2(queue_, 1, &submit, VK_NULL_HANDLE), "submitting commands");
    check(vkQueueWaitIdle(queue_), "waiting for the device");
    vkFreeCommandBuffers(device_, pool_, 1, &commands);
}

void Device::wait_idle() const { check(vkDeviceWaitIdle(device_), "waiting for the device"); }

} // namespace alpenglow
