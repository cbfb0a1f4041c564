#pragma once

#include "gpu/image.h"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace alpenglow {

/// An image of one frame's graph.
struct ImageId {
    static constexpr std::uint32_t none = ~0u;
    std::uint32_t index = none;

    explicit operator bool() const { return index != none; }
    bool operator==(ImageId const&) const = default;
};

/// What a pass does with an image. "update" keeps and changes what was there; "write" and "clear" replace it.
enum class ImageUse {
    sample,         ///< in any shader
    storage_write,  ///< compute; every texel is written
    storage_clear,  ///< compute, some texels; the others are cleared before the pass
    storage_update, ///< compute
    color_clear,
    color_update,
    depth_clear,
    depth_update,
    present,        ///< handed to the window
};

bool reads(ImageUse use);
bool writes(ImageUse use);
ImageState state_of(ImageUse use);

struct PlannedImage {
    std::string name;
    bool has_content = false; ///< imported with something in it
    ImageState before;        ///< of an imported image; what the frame before did with a transient one
};

struct ImageAccess {
    ImageId image;
    ImageUse use;
};

struct PlannedPass {
    std::string name;
    std::vector<ImageAccess> accesses;
};

struct PlannedBarrier {
    ImageId image;
    ImageState before, after;

    bool operator==(PlannedBarrier const&) const = default;
};

struct Plan {
    std::vector<std::vector<PlannedBarrier>> barriers; ///< for each pass, before it runs
    std::vector<ImageState> after;                     ///< for each image, when all passes have run
};

/// A graph that can't run: a programmer's mistake, reported in every build with the pass and the image.
struct GraphError : std::logic_error {
    using std::logic_error::logic_error;
};

/// The barriers between passes that run in the order given. Pure: needs no device. Forbidden: reading what nobody made,
/// one image twice in a pass, an unknown image.
Plan plan(std::span<PlannedImage const> images, std::span<PlannedPass const> passes);

} // namespace alpenglow
