#include "sandbox/settings_panel.h"

#include <cmath>
#include <imgui.h>

#include <vector>

namespace alpenglow {

namespace {

/// True where another one was chosen. An empty choice is shown as "the result".
bool choose(char const* label, std::string& value, std::span<std::string const> choices) {
    auto const text = [](std::string const& choice) { return choice.empty() ? "the result" : choice.c_str(); };
    if (!ImGui::BeginCombo(label, text(value))) return false;
    bool changed = false;
    for (std::string const& choice : choices) {
        if (ImGui::Selectable(text(choice), choice == value)) value = choice, changed = true;
    }
    ImGui::EndCombo();
    return changed;
}

struct Widget {
    SettingInfo const& info;
    char const* label;
    std::span<std::string const> images;

    bool edit(bool& value) const { return ImGui::Checkbox(label, &value); }

    bool edit(int& value) const {
        if (!info.choices.empty()) {
            std::string text = std::to_string(value);
            bool const changed = choose(label, text, choices_of(info));
            value = std::stoi(text);
            return changed;
        }
        // Sizes cost much when they change: typed, not dragged.
        if (info.unit == "texels") return ImGui::InputInt(label, &value, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue);
        bool const wide = info.largest / std::max(info.smallest, 1.0) > 100;
        return ImGui::SliderInt(label, &value, static_cast<int>(info.smallest), static_cast<int>(info.largest), "%d",
                                wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    }

    bool edit(double& value) const {
        bool const logarithmic = info.smallest > 0 && info.largest / info.smallest > 100;
        std::string const format = "%.6g " + std::string(info.unit);
        if (logarithmic)
            return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &info.smallest, &info.largest,
                                       format.c_str(), ImGuiSliderFlags_Logarithmic);
        return ImGui::DragScalar(label, ImGuiDataType_Double, &value, 0.02f, &info.smallest, &info.largest,
                                 format.c_str());
    }

    bool edit(std::string& value) const {
        std::vector<std::string> choices = choices_of(info);
        if (choices.empty()) {
            choices.emplace_back();
            choices.insert(choices.end(), images.begin(), images.end());
        }
        return choose(label, value, choices);
    }
};

} // namespace

void edit_settings(Settings& settings, std::span<std::string const> images) {
    for (SettingInfo const& info : setting_table()) {
        std::string const label(info.name);
        SettingValue value = get_setting(settings, info);
        Widget const widget{info, label.c_str(), images};
        bool const changed = std::visit([&](auto& plain) { return widget.edit(plain); }, value);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s (%s)", std::string(info.help).c_str(), range_text(info).c_str());
        // Typed numbers may be out of range; they are not taken.
        if (changed && in_range(info, value)) set_setting(settings, info, value);
    }
}

} // namespace alpenglow
