#include "render/frame_document.h"

#include <fmt/format.h>

namespace alpenglow {

namespace {

constexpr char const* HEAD = R"(# The frame

The default frame over a scene, in the order in which it runs; `engine/render/frame.cpp` is its text. This page is printed by the
program from the frame graph, and a test keeps it so. The air's tables are made in the first frame and whenever the air changes, at once or
spread over frames; `NAME_before` is what a table was one step ago. `terrain_height` and `shadow_ceiling` run when the sun or the scene changes, `terrain_above` when the scene does, and `terrain_sky`,
`terrain_glow`, `terrain_light` and `terrain_air` with any of them. Other settings add, repeat or leave out passes. A pass that runs several times in a row writes a
layer of its image each time, or goes to and fro between two images.

## Passes

| pass | kind | reads | writes |
|---|---|---|---|
)";

constexpr char const* IMAGES = R"(
## Images

Each name is what `--show NAME` takes (but for the picture, where it is shown) and the label in captures. A kept image outlives
the frame.

| image | format | bytes a texel | size | lives |
|---|---|---|---|---|
)";

std::string names(FrameGraph const& graph, PlannedPass const& pass, bool (*chosen)(ImageUse)) {
    std::vector<std::string> result;
    for (ImageAccess const& access : pass.accesses) {
        if (chosen(access.use)) result.push_back(graph.images()[access.image.index].name);
    }
    return fmt::format("{}", fmt::join(result, ", "));
}

std::string pass_line(FrameGraph const& graph, std::size_t index, PlannedPass const& planned, std::size_t repeats) {
    bool const compute = std::holds_alternative<ComputePass>(graph.passes()[index].work);
    std::string const times = repeats > 1 ? fmt::format(" ({} times)", repeats) : "";
    return fmt::format("| {}{} | {} | {} | {} |\n", planned.name, times, compute ? "compute" : "raster",
                       names(graph, planned, reads), names(graph, planned, writes));
}

char const* format_name(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R8G8B8A8_UNORM:
        return "R8G8B8A8_UNORM";
    case VK_FORMAT_R8G8B8A8_SRGB:
        return "R8G8B8A8_SRGB";
    case VK_FORMAT_B8G8R8A8_UNORM:
        return "B8G8R8A8_UNORM";
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
        return "B10G11R11_UFLOAT";
    case VK_FORMAT_R16G16B16A16_SNORM:
        return "R16G16B16A16_SNORM";
    case VK_FORMAT_R16G16B16A16_SFLOAT:
        return "R16G16B16A16_SFLOAT";
    case VK_FORMAT_R32_SFLOAT:
        return "R32_SFLOAT";
    case VK_FORMAT_R32G32_SFLOAT:
        return "R32G32_SFLOAT";
    case VK_FORMAT_R32G32B32A32_SFLOAT:
        return "R32G32B32A32_SFLOAT";
    case VK_FORMAT_D32_SFLOAT:
        return "D32_SFLOAT";
    default:
        return "unknown";
    }
}

std::string size_text(ImageShape const& shape, Extent frame) {
    if (shape.extent == frame && shape.layers == 1) return "the frame's";
    std::string const layers = shape.layers > 1 ? fmt::format(", {} layers", shape.layers) : "";
    return fmt::format("{}x{}{}", shape.extent.width, shape.extent.height, layers);
}

std::string image_line(FrameGraph::Image const& image, Extent frame) {
    return fmt::format("| {} | {} | {} | {} | {} |\n", image.name, format_name(image.shape.format),
                       bytes_per_texel(image.shape.format), size_text(image.shape, frame),
                       image.imported ? "kept" : "for the frame");
}

} // namespace

std::string frame_document(FrameGraph const& graph) {
    std::string text = HEAD;
    std::vector<PlannedPass> const passes = graph.planned_passes();
    for (std::size_t i = 0, next = 0; i < graph.passes().size(); i = next) {
        for (next = i + 1; next < graph.passes().size() &&
                           pass_line(graph, next, passes[next], 1) == pass_line(graph, i, passes[i], 1);)
            ++next;
        text += pass_line(graph, i, passes[i], next - i);
    }
    text += IMAGES;
    Extent const frame = graph.shape(graph.find("picture")).extent;
    for (FrameGraph::Image const& image : graph.images()) text += image_line(image, frame);
    return text;
}

} // namespace alpenglow
