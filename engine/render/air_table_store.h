#pragma once

#include "gpu/image.h"
#include "render/air_table_schedule.h"

#include <array>
#include <map>
#include <memory>
#include <optional>

namespace alpenglow {

/// One table: its finished state, and an image in which the next is made. A step that is done makes them change places.
struct TwofoldTable {
    std::array<std::unique_ptr<GpuImage>, 2> images;
    std::size_t finished = 0;            ///< which of them is
    std::array<bool, 2> has_content{};   ///< somebody wrote to it
};

/// The tables that the models of the air keep from frame to frame. A model's are there from its first frame on, and
/// stay while another model draws.
class AirTableStore {
public:
    explicit AirTableStore(Device const& device) : device_(device) {}

    struct Kept {
        AirModel const& model;
        std::vector<TwofoldTable> tables{}; ///< in the model's order
        std::optional<shader::Atmosphere> made_for{}; ///< or being made
        std::string planet{};                         ///< whose air that is
        TableProgress progress{};

        bool finished() const { return progress.step == model.steps.size(); }
        /// The finished table of that name; nullptr where there is none.
        GpuImage* find(std::string_view name) const;
    };
    /// Makes the images where there are none yet.
    Kept& of(AirModel const& model);
    /// From now on they hold nothing.
    void discard();

private:
    Device const& device_;
    std::map<std::string_view, Kept> kept_; ///< by the model's name
};

/// Where the making goes on when this frame's air is `air` of `planet`: at the start where it is another, and all at
/// once where tables of that planet have never been made, or not to be `spread` over frames.
struct TableWork {
    TableProgress start;
    std::vector<StepSlice> slices; ///< of this frame
};
TableWork table_work(AirTableStore::Kept const& tables, shader::Atmosphere const& air, std::string const& planet,
                     bool spread, TablePace const& pace);

/// Takes down what a frame with that work has done.
void finish_work(AirTableStore::Kept& tables, shader::Atmosphere const& air, std::string const& planet,
                 TableWork const& work);

} // namespace alpenglow
