#include "render/air_table_store.h"

#include "render/models/models.h"

#include <cstring>

namespace alpenglow {

namespace {

constexpr VkImageUsageFlags TABLE_USAGE =
    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

bool same(shader::Atmosphere const& a, shader::Atmosphere const& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

} // namespace

AirTableStore::Kept& AirTableStore::of(AirModel const& model) {
    auto const [entry, is_new] = kept_.try_emplace(model.name, Kept{model});
    Kept& kept = entry->second;
    if (is_new) {
        for (AirTable const& table : model.tables) {
            ImageShape const shape{VK_FORMAT_R32G32B32A32_SFLOAT, table.size};
            TwofoldTable& images = kept.tables.emplace_back();
            for (auto& image : images.images)
                image = std::make_unique<GpuImage>(device_, shape, TABLE_USAGE, table.name);
        }
    }
    return kept;
}

AirTableStore::Kept* AirTableStore::unfinished(shader::Atmosphere const& air) {
    for (AirModel const& model : air_models()) {
        if (Kept& kept = of(model); !kept.finished_for(air)) return &kept;
    }
    return nullptr;
}

void AirTableStore::discard() {
    for (auto& [model, kept] : kept_) kept.made_for.reset(), kept.planet.clear();
}

bool AirTableStore::Kept::finished_for(shader::Atmosphere const& air) const {
    std::size_t const steps = model.steps(air).size();
    return progress.step == steps && (steps == 0 || (made_for && same(*made_for, air)));
}

GpuImage* AirTableStore::Kept::find(std::string_view name) const {
    for (std::size_t i = 0; i < tables.size(); ++i) {
        if (model.tables[i].name == name) return tables[i].images[tables[i].finished].get();
    }
    return nullptr;
}

TableWork table_work(AirTableStore::Kept const& tables, shader::Atmosphere const& air, bool spread,
                     TablePace const& pace) {
    bool const goes_on = tables.made_for && same(*tables.made_for, air);
    TableProgress const start = goes_on ? tables.progress : TableProgress{};
    std::vector<AirTableStep> const& steps = tables.model.steps(air);
    return {start, spread ? next_slices(steps, start, pace) : remaining_slices(steps, start)};
}

void finish_work(AirTableStore::Kept& tables, shader::Atmosphere const& air, std::string const& planet,
                 TableWork const& work) {
    std::vector<AirTableStep> const& steps = tables.model.steps(air);
    for (StepSlice const& slice : work.slices) {
        TwofoldTable& table = tables.tables[steps[slice.step].makes.table];
        table.has_content[1 - table.finished] = true;
        if (slice.first + slice.count == steps[slice.step].groups) table.finished = 1 - table.finished;
    }
    tables.made_for = air;
    tables.progress = advanced(steps, work.start, work.slices);
    if (tables.finished_for(air)) {
        tables.planet = planet;
    } else if (tables.planet != planet) {
        tables.planet.clear();
    }
}

} // namespace alpenglow
