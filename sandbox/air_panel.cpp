#include "sandbox/air_panel.h"

#include "scene/air_changes.h"
#include "scene/file_keys.h"

#include <imgui.h>

namespace alpenglow {

namespace {

void edit_number(double& value, json::NumberKey const& key) {
    std::string const label(key.name);
    ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &value, &key.smallest, &key.largest, "%.3g");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(key.help).c_str());
}

void edit_phase(Phase& phase) {
    auto const name = [](std::size_t kind) { return std::string(json::PHASE_KINDS[kind]); };
    auto const chosen = static_cast<std::size_t>(phase.kind);
    if (ImGui::BeginCombo("phase", name(chosen).c_str())) {
        for (std::size_t kind = 0; kind < json::PHASE_KINDS.size(); ++kind)
            if (ImGui::Selectable(name(kind).c_str(), kind == chosen)) phase.kind = static_cast<Phase::Kind>(kind);
        ImGui::EndCombo();
    }
    for (json::NumberKey const& key : phase_numbers(phase.kind)) edit_number(phase_number(phase, key), key);
}

} // namespace

void edit_air(Settings& settings, Air const& planet_air) {
    Air air = changed_air(planet_air, settings.air_without, settings.air_phases);
    for (AirComponent& component : air.components) {
        ImGui::PushID(component.name.c_str());
        ImGui::Checkbox(component.name.c_str(), &component.on);
        if (component.on && component.scattering != glm::dvec3(0)) edit_phase(component.phase);
        ImGui::PopID();
    }
    settings.air_without = names_switched_off(air);
    settings.air_phases = phases_beside(planet_air, air);
}

} // namespace alpenglow
