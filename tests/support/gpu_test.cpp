#include "support/gpu_test.h"

#include "gpu/transfer.h"
#include "render/executor.h"

#include <memory>

namespace alpenglow::test {

namespace {

std::unique_ptr<Device>& shared_device() {
    static std::unique_ptr<Device> device;
    return device;
}

std::vector<void (*)()>& lasts() {
    static std::vector<void (*)()> list;
    return list;
}

/// Takes the device down while the driver's own statics still live.
struct DeviceEnvironment : ::testing::Environment {
    void TearDown() override {
        for (auto const last : lasts()) last();
        shared_device().reset();
    }
};

} // namespace

Device const& GpuTest::device() {
    std::unique_ptr<Device>& device = shared_device();
    if (!device) {
        ::testing::AddGlobalTestEnvironment(new DeviceEnvironment);
        DeviceOptions options;
        options.validation = true;
        device = std::make_unique<Device>(options);
    }
    return *device;
}

void GpuTest::TearDown() {
    std::vector<std::string> const messages = device().messages();
    for (std::size_t i = seen_; i < messages.size(); ++i) ADD_FAILURE() << messages[i];
}

void at_end_of_tests(void (*last)()) { lasts().push_back(last); }

std::unique_ptr<GpuImage> make_float_image(Device const& device, std::vector<glm::vec4> const& texels, Extent extent) {
    constexpr VkImageUsageFlags usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    auto image = std::make_unique<GpuImage>(device, ImageShape{VK_FORMAT_R32G32B32A32_SFLOAT, extent}, usage, "synthetic");
    upload(device, *image, std::as_bytes(std::span(texels)));
    return image;
}

std::vector<glm::vec4> run_compute(Device const& device, ShaderCode const& shader, std::vector<glm::vec4> const& input, Extent extent,
                                   std::vector<std::byte> const& push) {
    auto const from = make_float_image(device, input, extent), to = make_float_image(device, input, extent);
    FrameGraph graph;
    ImageId const read = graph.import(*from, "input", ShowScale::unit, true);
    ImageId const written = graph.import(*to, "output", ShowScale::unit, false);
    graph.add(ComputePass{"test", shader, {sampled(0, read, NEAREST_CLAMP), stored(1, written)}, extent, push});
    Executor executor(device);
    executor.submit(graph);
    executor.wait();
    return values_of<glm::vec4>(read_back(device, *to));
}

} // namespace alpenglow::test
