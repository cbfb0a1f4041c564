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

/// A table, by its place in the model's list, and the slot it is bound to.
struct TableUse {
    std::size_t table;
    std::uint32_t slot;
    SamplerState sampler = LINEAR_CLAMP;
};

/// A part of making a model's tables: one pass that makes one table from finished ones, which may be its own last state.
/// Its workgroups stand in a row and may run in different frames; the shader gets the number of the first as
/// shader::AirTablePush. What it makes is seen when it is done.
struct AirTableStep {
    std::string pass;
    ShaderCode shader;
    std::uint32_t groups; ///< workgroups in all
    std::vector<TableUse> reads;
    TableUse makes;
    int mode = 0;         ///< the pass's own
    bool updates = false; ///< it also reads what the table held before its last state
};

/// What a frame has of a model's tables.
struct AirTableInputs {
    FrameInputs const& in;
    ConstantsId frame;
    std::vector<ImageId> tables; ///< the model's, finished, in its order
};

/// What makes no tables.
std::vector<AirTableStep> const& no_steps(shader::Atmosphere const& air);

/// A way to light the air. One file in this folder declares it, one file in shaders/models computes it, and
/// `air_models` lists it: docs/adding_a_model.md.
struct AirModel {
    std::string_view name; ///< as the setting `model` knows it
    std::string_view help;
    ShaderCode air, air_repair, lighting; ///< the passes with shaders/models/NAME.glsl in them
    std::vector<AirTable> tables{};    ///< what it keeps from frame to frame
    /// That make them, in order, when the air changes; of one of the model's lists of steps, which all have the same passes.
    std::vector<AirTableStep> const& (*steps)(shader::Atmosphere const& air) = no_steps;
    /// Gives what these passes bind behind their own slots, numbered from AIR_MODEL_SLOT on, and declares the
    /// passes that fill tables of this frame's view.
    std::vector<Slot> (*slots)(FrameGraph& graph, AirTableInputs const& inputs);
    /// Tables over that ground, from which the light on terrain is made. Models without this light surfaces as if all
    /// around were level.
    SkyTables (*sky)(FrameGraph& graph, AirTableInputs const& inputs, GroundAround const& ground) = nullptr;
    /// Which variant of the air's passes draws this frame: their specialization constant 0. Models without any have none.
    int (*air_variant)(FrameInputs const& in) = nullptr;
    /// From one pixel to the next whose air is worked out [pixels]: 1, 2 or 4; between them it is interpolated where it
    /// is smooth. Models without this work out every pixel's.
    int (*air_stride)(Settings const& settings) = nullptr;
    bool finds_shafts = false; ///< its air asks the shadows' bounds where it is lit
    /// What the model leaves out or can't do in this world, with meshes in it or without, in one sentence; empty where
    /// it applies in full.
    std::string_view (*limits)(World const& world, Settings const& settings, bool meshes);
};

} // namespace alpenglow
