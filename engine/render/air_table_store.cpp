#include "render/air_table_store.h"

namespace alpenglow {

namespace {

constexpr VkImageUsageFlags TABLE_USAGE =
    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

} // namespace

AirTableStore::Kept& AirTableStore::of(AirModel const& model) {
    last_ = &model;
    auto const [entry, is_new] = kept_.try_emplace(model.name);
    if (is_new) {
        for (AirTable const& table : model.tables) {
            ImageShape const shape{VK_FORMAT_R32G32B32A32_SFLOAT, table.size};
            entry->second.images.push_back(std::make_unique<GpuImage>(device_, shape, TABLE_USAGE, table.name));
        }
    }
    return entry->second;
}

void AirTableStore::discard() {
    for (auto& [model, kept] : kept_) kept.made_for.reset();
}

GpuImage* AirTableStore::find(std::string_view name) const {
    if (!last_) return nullptr;
    for (std::size_t i = 0; i < last_->tables.size(); ++i) {
        if (last_->tables[i].name == name) return kept_.at(last_->name).images[i].get();
    }
    return nullptr;
}

} // namespace alpenglow
