#include "gpu/buffer.h"

namespace alpenglow {

GpuBuffer::GpuBuffer(Device const& device, VkDeviceSize bytes, VkBufferUsageFlags usage, BufferHome home,
                     std::string const& name)
    : device_(device), bytes_(bytes) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes;
    info.usage = usage;
    check(vkCreateBuffer(device.handle(), &info, nullptr, &buffer_), "making the buffer " + name);
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device.handle(), buffer_, &needs);
    VkMemoryPropertyFlags const flags =
        home == BufferHome::device ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
                                   : VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    try {
        memory_ = device.allocate(needs, flags);
    } catch (...) {
        vkDestroyBuffer(device.handle(), buffer_, nullptr);
        throw;
    }
    allocated_ = needs.size;
    check(vkBindBufferMemory(device.handle(), buffer_, memory_, 0), "binding the buffer " + name);
    if (home == BufferHome::host)
        check(vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped_), "mapping the buffer " + name);
    device.set_name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(buffer_), name);
}

GpuBuffer::~GpuBuffer() {
    vkDestroyBuffer(device_.handle(), buffer_, nullptr);
    device_.free(memory_, allocated_);
}

} // namespace alpenglow
