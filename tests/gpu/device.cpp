#include "gpu/buffer.h"
#include "gpu/transfer.h"
#include "support/files.h"
#include "support/gpu_test.h"

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

class DeviceTest : public GpuTest {};

} // namespace

TEST_F(DeviceTest, validation_is_there_and_speaks) {
    // Proves that the other tests would hear of a mistake: a barrier to a layout that the image's usage doesn't allow.
    GpuImage image(device(), {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}}, VK_IMAGE_USAGE_SAMPLED_BIT, "misused");
    device().run_once([&](VkCommandBuffer commands) {
        record_barriers(commands, {image_barrier(image.handle(), VK_IMAGE_ASPECT_COLOR_BIT, {}, TRANSFER_TARGET)});
    });
    EXPECT_GT(new_messages(), 0u);
    forget_messages();
}

TEST_F(DeviceTest, what_is_uploaded_is_read_back) {
    std::vector<glm::vec4> texels(64);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = glm::vec4(float(i), -1.5f, 1e-30f, 1e30f);
    EXPECT_EQ(values_of<glm::vec4>(read_back(device(), *make_float_image(device(), texels, {8, 8}))), texels);
}

TEST_F(DeviceTest, memory_is_counted_and_given_back) {
    std::uint64_t const before = device().memory_in_use();
    {
        auto const image = make_float_image(device(), std::vector<glm::vec4>(256 * 256), {256, 256});
        EXPECT_GE(device().memory_in_use(), before + 256 * 256 * 16);
    }
    EXPECT_EQ(device().memory_in_use(), before);
}

TEST_F(DeviceTest, what_does_not_fit_is_an_error_and_takes_nothing) {
    std::uint64_t const before = device().memory_in_use();
    expect_error(ErrorKind::device, {"memory", "--size"}, [&] {
        GpuBuffer const buffer(device(), VkDeviceSize{1} << 50, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferHome::device, "everything");
    });
    EXPECT_EQ(device().memory_in_use(), before);
    forget_messages(); // validation warns of the size
}
