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
        TableProgress progress{};
        std::string planet{}; ///< in whose air they were last finished and may be read; none: never, or discarded

        bool finished_for(shader::Atmosphere const& air) const;
        /// The finished table of that name; nullptr where there is none.
        GpuImage* find(std::string_view name) const;
    };
    /// Makes the images where there are none yet.
    Kept& of(AirModel const& model);
    /// Those of the first model whose tables are not finished for that air; nullptr where all are.
    Kept* unfinished(shader::Atmosphere const& air);
    /// From now on they hold nothing.
    void discard();

private:
    Device const& device_;
    std::map<std::string_view, Kept> kept_; ///< by the model's name
};

/// Where the making goes on when this frame's air is `air`: at the start where it is another. It runs to the end where
/// it is not to be `spread` over frames.
struct TableWork {
    TableProgress start;
    std::vector<StepSlice> slices; ///< of this frame
};
TableWork table_work(AirTableStore::Kept const& tables, shader::Atmosphere const& air, bool spread,
                     TablePace const& pace);

/// Takes down what a frame with that work, in `air` of `planet`, has done.
void finish_work(AirTableStore::Kept& tables, shader::Atmosphere const& air, std::string const& planet,
                 TableWork const& work);

} // namespace alpenglow
