#include "sandbox/panel.h"

#include "sandbox/settings_panel.h"

#include <imgui.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>

#include <array>
#include <cmath>

namespace alpenglow {

namespace {

constexpr float FONT_PIXELS = 13; // the size that ImGui's font is drawn for
constexpr float MARGIN = 10;      // [points] between windows and the edge
constexpr ImGuiWindowFlags PLAIN = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

std::string distance_text(double metres) {
    if (std::abs(metres) < 10'000) return fmt::format("{:.0f} m", metres);
    return std::abs(metres) < 1e7 ? fmt::format("{:.1f} km", metres / 1000) : fmt::format("{:.0f} km", metres / 1000);
}

std::string date_text(double day_of_year) {
    constexpr std::array<char const*, 12> NAMES = {"January",   "February", "March",    "April",
                                                   "May",       "June",     "July",     "August",
                                                   "September", "October",  "November", "December"};
    constexpr std::array LENGTHS = {31.0, 28.25, 31.0, 30.0, 31.0, 30.0, 31.0, 31.0, 30.0, 31.0, 30.0, 31.0};
    std::size_t month = 0;
    while (month + 1 < NAMES.size() && day_of_year >= LENGTHS[month]) day_of_year -= LENGTHS[month++];
    return fmt::format("{} {}", 1 + static_cast<int>(day_of_year), NAMES[month]);
}

std::string hour_text(double hour) {
    int const minutes = static_cast<int>(std::lround(hour * 60)) % (24 * 60);
    return fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
}

void show_place(Pilot const& pilot) {
    CameraPlace const& camera = pilot.view().camera;
    double const altitude = camera.place.altitude;
    ImGui::Text("%.4f, %.4f  heading %.0f", glm::degrees(camera.place.latitude), glm::degrees(camera.place.longitude),
                std::fmod(glm::degrees(camera.heading) + 360, 360));
    ImGui::Text("altitude %s, above ground %s", distance_text(altitude).c_str(),
                distance_text(altitude - pilot.ground_altitude()).c_str());
    ImGui::Text("speed %s/s", distance_text(pilot.speed()).c_str());
}

void edit_sun(Pilot& pilot) {
    if (!pilot.sun()) return;
    auto hour = static_cast<float>(pilot.sun()->hour()), day = static_cast<float>(pilot.sun()->day());
    if (ImGui::SliderFloat("sun's hour", &hour, 0, 24, hour_text(hour).c_str()))
        pilot.add_sun_hours(double(hour) - pilot.sun()->hour());
    if (ImGui::SliderFloat("day", &day, 0, float(SunClock::DAYS_IN_YEAR), date_text(day).c_str()))
        pilot.add_sun_days(double(day) - pilot.sun()->day());
    ImGui::Text("elevation %.1f, azimuth %.1f", glm::degrees(pilot.view().sun.elevation),
                glm::degrees(pilot.view().sun.azimuth));
}

void show_report(PictureReport const& report, Screen& screen) {
    double sum = 0;
    for (PassTime const& pass : report.passes) sum += pass.gpu_ms;
    ImGui::Text("%.1f ms on the device, %u x %u", sum, report.drawn.width, report.drawn.height);
    ImGui::Text("exposure %.2f stops, on its way to %.2f", report.exposure, report.exposure_target);
    ImGui::Checkbox("smaller while it moves", &screen.adapt_share);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("draws fewer pixels while the view changes, where the device is slow");
    for (PassTime const& pass : report.passes) ImGui::Text("%9.2f  %s", pass.gpu_ms, pass.name.c_str());
}

void show_panel(KeyTarget target, PictureReport const& report) {
    ImGui::SetNextWindowPos({MARGIN, MARGIN}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({0, 0},
                                        {ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y - 2 * MARGIN});
    if (ImGui::Begin("Alpenglow", &target.screen.panel, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushItemWidth(ImGui::GetFontSize() * 10);
        show_place(target.pilot);
        ImGui::Separator();
        edit_sun(target.pilot);
        ImGui::Separator();
        edit_settings(target.pilot.settings(), target.screen.images);
        if (!target.screen.model_limits.empty()) ImGui::TextWrapped("%s", target.screen.model_limits.c_str());
        if (ImGui::CollapsingHeader("Time of each pass [ms]", ImGuiTreeNodeFlags_DefaultOpen))
            show_report(report, target.screen);
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

void show_help() {
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x - MARGIN, MARGIN}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("help", nullptr, PLAIN);
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (KeyRow const& row : key_rows()) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(row.keys);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(row.meaning);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

/// At the lower edge, over everything.
void show_message(std::string const& message) {
    ImVec2 const size = ImGui::GetIO().DisplaySize, text = ImGui::CalcTextSize(message.c_str());
    ImVec2 const gap = ImGui::GetStyle().WindowPadding;
    ImVec2 const corner{std::floor(0.5f * (size.x - text.x)), std::floor(size.y - text.y - 2 * gap.y - MARGIN)};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({corner.x - gap.x, corner.y - gap.y}, {corner.x + text.x + gap.x, corner.y + text.y + gap.y},
                       ImGui::GetColorU32(ImGuiCol_WindowBg, 0.7f));
    list.AddText(corner, ImGui::GetColorU32(ImGuiCol_Text), message.c_str());
}

/// ImGui's clip rectangle in pixels, cut to the window.
VkRect2D clip_of(ImVec4 const& clip, ImDrawData const& data) {
    ImVec2 const scale = data.FramebufferScale;
    float const width = data.DisplaySize.x * scale.x, height = data.DisplaySize.y * scale.y;
    auto const pixel = [](float points, float factor, float largest) {
        return static_cast<std::int32_t>(std::clamp(points * factor, 0.0f, largest));
    };
    std::int32_t const left = pixel(clip.x, scale.x, width), top = pixel(clip.y, scale.y, height);
    std::int32_t const right = pixel(clip.z, scale.x, width), bottom = pixel(clip.w, scale.y, height);
    return {
        {left, top},
        {static_cast<std::uint32_t>(std::max(right - left, 0)), static_cast<std::uint32_t>(std::max(bottom - top, 0))}};
}

void append(OverlayMesh& mesh, ImDrawList const& list, ImDrawData const& data) {
    auto const first_index = static_cast<std::uint32_t>(mesh.indices.size());
    auto const first_vertex = static_cast<std::uint32_t>(mesh.vertices.size());
    for (ImDrawVert const& vertex : list.VtxBuffer)
        mesh.vertices.push_back({{vertex.pos.x, vertex.pos.y}, {vertex.uv.x, vertex.uv.y}, vertex.col});
    mesh.indices.insert(mesh.indices.end(), list.IdxBuffer.begin(), list.IdxBuffer.end());
    for (ImDrawCmd const& command : list.CmdBuffer) {
        VkRect2D const clip = clip_of(command.ClipRect, data);
        if (clip.extent.width == 0 || clip.extent.height == 0 || command.ElemCount == 0) continue;
        mesh.draws.push_back({clip, first_index + command.IdxOffset, command.ElemCount,
                              static_cast<std::int32_t>(first_vertex + command.VtxOffset)});
    }
}

} // namespace

Panel::Panel(Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    ImGui_ImplGlfw_InitForVulkan(window.native(), true);
    // Where the window system scales by itself, points are large already; elsewhere letters and gaps have to grow.
    auto const scale =
        static_cast<float>(window.content_scale() * window.height() / std::max(1u, window.framebuffer().height));
    ImGui::StyleColorsDark();
    ImGui::GetStyle().ScaleAllSizes(scale);
    ImFontConfig font;
    font.SizePixels = std::floor(FONT_PIXELS * scale);
    io.Fonts->AddFontDefault(&font);
}

Panel::~Panel() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

ByteImage Panel::texture() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ByteImage image({static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)});
    image.rgba.assign(pixels, pixels + image.rgba.size());
    return image;
}

void Panel::begin() {
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

bool Panel::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }

bool Panel::wants_keyboard() const { return ImGui::GetIO().WantTextInput; }

OverlayMesh Panel::finish(KeyTarget target, PictureReport const& report, std::string const& message) {
    if (target.screen.panel) show_panel(target, report);
    if (target.screen.help) show_help();
    if (!message.empty()) show_message(message);
    ImGui::Render();
    ImDrawData const& data = *ImGui::GetDrawData();
    OverlayMesh mesh;
    mesh.size = {data.DisplaySize.x, data.DisplaySize.y};
    for (int i = 0; i < data.CmdListsCount; ++i) append(mesh, *data.CmdLists[i], data);
    return mesh;
}

} // namespace alpenglow
