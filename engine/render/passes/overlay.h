#pragma once

#include "gpu/buffer.h"
#include "image/image.h"
#include "render/frame_graph.h"

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace alpenglow {

struct OverlayVertex {
    glm::vec2 place;     ///< [points] from the upper left corner
    glm::vec2 uv;        ///< in the overlay's texture
    std::uint32_t color; ///< sRGB-encoded with straight alpha; red in the lowest byte
};

struct OverlayDraw {
    VkRect2D clip{}; ///< [pixels], within the window
    std::uint32_t first_index = 0, index_count = 0;
    std::int32_t vertex_offset = 0;
};

/// Flat triangles in the order drawn.
struct OverlayMesh {
    glm::vec2 size{1}; ///< [points] of the whole window
    std::vector<OverlayVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<OverlayDraw> draws;
};

/// Draws flat triangles, such as a panel's, over an image. Owns their texture and, for each frame in flight, their
/// buffers.
class Overlay {
public:
    Overlay(Device const& device, ByteImage const& texture, std::uint32_t frames_in_flight);
    ~Overlay();

    /// `decode`: the window encodes what is written as sRGB. At most one overlay in a frame.
    void add(FrameGraph& graph, ImageId window, OverlayMesh mesh, bool decode);

private:
    struct Buffers {
        std::unique_ptr<GpuBuffer> vertices, indices;
    };
    void draw(DrawContext& context, OverlayMesh const& mesh, bool decode);

    Device const& device_;
    GpuImage texture_;
    std::vector<Buffers> buffers_;
    std::size_t next_ = 0;
};

} // namespace alpenglow
