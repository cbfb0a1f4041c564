#include "render/models/models.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace alpenglow {

AirModel make_march();
AirModel make_naive();
AirModel make_tables();

std::span<AirModel const> air_models() {
    static std::array const MODELS{make_march(), make_naive(), make_tables()};
    return MODELS;
}

std::vector<AirTableStep> const& no_steps(shader::Atmosphere const&) {
    static std::vector<AirTableStep> const NONE;
    return NONE;
}

AirModel const& air_model(std::string_view name) {
    std::span<AirModel const> const models = air_models();
    auto const found = std::ranges::find(models, name, &AirModel::name);
    if (found != models.end()) return *found;
    std::string names;
    for (AirModel const& model : models) names += (names.empty() ? "" : ", ") + std::string(model.name);
    throw Error(ErrorKind::wrong_use, "there is no model '" + std::string(name) + "'", {}, "the models are: " + names);
}

std::set<std::string> const& table_passes() {
    static auto const NAMES = [] {
        std::set<std::string> names;
        for (AirModel const& model : air_models()) {
            for (AirTableStep const& step : model.steps({})) names.insert(step.pass);
        }
        return names;
    }();
    return NAMES;
}

std::string model_limits(World const& world, Settings const& settings, bool meshes) {
    AirModel const& model = air_model(settings.model);
    if (!world.planet.has_air || !settings.air) return {};
    std::string_view const limits = model.limits(world, settings, meshes);
    return limits.empty() ? std::string() : fmt::format("model {}: {}", model.name, limits);
}

} // namespace alpenglow
