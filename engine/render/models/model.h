#pragma once

#include "render/frame.h"

#include <string>
#include <string_view>
#include <vector>

namespace alpenglow {

/// A table of the air that outlives the frame: four floats a texel.
struct AirTable {
    std::string name; ///< as `show` knows it
    Extent size;      ///< [texels]
    ShowScale scale;
};

/// What a model's tables are made from.
struct AirTableInputs {
    FrameInputs const& in;
    ConstantsId frame;
    std::vector<ImageId> tables; ///< the model's own, in its order
    bool stale;                  ///< they hold nothing, or another air's
};

/// A way to light the air. One file in this folder declares it, one file in shaders/models computes it, and
/// `air_models` lists it: docs/adding_a_model.md.
struct AirModel {
    std::string_view name; ///< as the setting `model` knows it
    std::string_view help;
    ShaderCode lighting;            ///< the lighting pass with shaders/models/NAME.glsl in it
    std::vector<AirTable> tables{}; ///< what it keeps from frame to frame
    /// Declares the passes that fill the tables, and gives what the lighting pass binds behind its own slots, numbered
    /// from LIGHTING_MODEL_SLOT on. Tables that are not stale stay as they are.
    std::vector<Slot> (*add_tables)(FrameGraph& graph, AirTableInputs const& inputs);
    /// What the model leaves out or can't do in this world, with meshes in it or without, in one sentence; empty where
    /// it applies in full.
    std::string_view (*limits)(World const& world, Settings const& settings, bool meshes);
};

} // namespace alpenglow
