#include "render/passes/overlay.h"

#include "gpu/transfer.h"
#include "interop/overlay.h"

#include <embedded_shaders.h>

#include <bit>
#include <cstddef>

namespace alpenglow {

namespace {

VertexLayout vertex_layout() {
    return {sizeof(OverlayVertex),
            {{OVERLAY_PLACE, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(OverlayVertex, place)},
             {OVERLAY_UV, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(OverlayVertex, uv)},
             {OVERLAY_COLOR, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(OverlayVertex, color)}}};
}

template <typename T>
void fill(Device const& device, std::unique_ptr<GpuBuffer>& buffer, std::vector<T> const& values,
          VkBufferUsageFlags usage, char const* name) {
    auto const bytes = std::as_bytes(std::span(values));
    if (!buffer || buffer->bytes() < bytes.size())
        buffer = std::make_unique<GpuBuffer>(device, std::bit_ceil(bytes.size()), usage, BufferHome::host, name);
    std::ranges::copy(bytes, buffer->mapped().begin());
}

} // namespace

Overlay::Overlay(Device const& device, ByteImage const& texture, std::uint32_t frames_in_flight)
    : device_(device), texture_(device, {VK_FORMAT_R8G8B8A8_UNORM, texture.extent},
                                VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "overlay_texture"),
      buffers_(frames_in_flight) {
    upload(device, texture_, std::as_bytes(std::span(texture.rgba)));
}

Overlay::~Overlay() { vkDeviceWaitIdle(device_.handle()); }

void Overlay::add(FrameGraph& graph, ImageId window, OverlayMesh mesh, bool decode) {
    if (mesh.draws.empty()) return;
    RasterPass pass;
    pass.name = "overlay";
    pass.colors = {window};
    pass.slots = {sampled(OVERLAY_TEXTURE_SLOT, graph.import(texture_, "overlay_texture", ShowScale::unit, true))};
    pass.pipelines = {RasterState{.vertex = shaders::overlay_vert,
                                  .fragment = shaders::overlay_frag,
                                  .vertices = vertex_layout(),
                                  .blend = true}};
    pass.draw = [this, mesh = std::move(mesh), decode](DrawContext& context) { draw(context, mesh, decode); };
    graph.add(std::move(pass));
}

/// Runs while commands are recorded: the frame that used these buffers before is finished by then.
void Overlay::draw(DrawContext& context, OverlayMesh const& mesh, bool decode) {
    Buffers& buffers = buffers_[next_];
    next_ = (next_ + 1) % buffers_.size();
    fill(device_, buffers.vertices, mesh.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "overlay vertices");
    fill(device_, buffers.indices, mesh.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "overlay indices");

    context.use(0);
    context.push(bytes_of(shader::OverlayPush{2.0f / mesh.size, decode}));
    VkCommandBuffer const commands = context.commands();
    VkBuffer const vertices = buffers.vertices->handle();
    VkDeviceSize const start = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &start);
    vkCmdBindIndexBuffer(commands, buffers.indices->handle(), 0, VK_INDEX_TYPE_UINT32);
    for (OverlayDraw const& part : mesh.draws) {
        vkCmdSetScissor(commands, 0, 1, &part.clip);
        vkCmdDrawIndexed(commands, part.index_count, 1, part.first_index, part.vertex_offset, 0);
    }
}

} // namespace alpenglow
