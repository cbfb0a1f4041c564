#pragma once

#include "gpu/image.h"
#include "render/models/model.h"

#include <map>
#include <memory>
#include <optional>

namespace alpenglow {

/// The tables that the models of the air keep from frame to frame. A model's are there from its first frame on, and
/// stay while another model draws.
class AirTableStore {
public:
    explicit AirTableStore(Device const& device) : device_(device) {}

    struct Kept {
        std::vector<std::unique_ptr<GpuImage>> images; ///< in the order of the model's tables
        std::optional<shader::Atmosphere> made_for;
    };
    /// Makes the images where there are none yet.
    Kept& of(AirModel const& model);
    /// From now on they hold nothing.
    void discard();
    /// Of the model that was asked for last; nullptr where it has none of that name.
    GpuImage* find(std::string_view name) const;

private:
    Device const& device_;
    std::map<std::string_view, Kept> kept_; ///< by the model's name
    AirModel const* last_ = nullptr;
};

} // namespace alpenglow
