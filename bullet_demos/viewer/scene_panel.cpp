#include "viewer/scene_panel.h"

#include <filesystem>

#include "viewer/panel_parts.h"

namespace demo {
namespace {

void chooseScene(ViewerState& state, const std::vector<std::string>& files) {
    std::vector<std::string> names;
    for (const std::string& file : files) names.push_back(std::filesystem::path(file).stem().string());
    std::string name = std::filesystem::path(state.choices.file).filename().string();
    if (state.choices.isScene()) name = std::filesystem::path(name).stem().string();
    if (chooseName("scene", name, names, nullptr))
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == name) {
                state.choices = Choices();
                state.choices.file = files[i];
                state.reload = true;
            }
    if (state.choices.isScene()) return;
    OwnMesh& mesh = state.choices.own_mesh;
    state.reload |= ImGui::Checkbox("repair the mesh", &mesh.repair);
    float shell = float(1e3 * mesh.shell_thickness_m);
    ImGui::SliderFloat("hollow, wall", &shell, 0, 20, shell > 0 ? "%.1f mm" : "solid");
    state.reload |= ImGui::IsItemDeactivatedAfterEdit();
    mesh.shell_thickness_m = 1e-3 * shell;
    float height = float(mesh.drop_height_m);
    ImGui::SliderFloat("drop from", &height, 0, 3, "%.2f m");
    if (ImGui::IsItemDeactivatedAfterEdit()) state.restart = true;
    mesh.drop_height_m = height;
}

/// Scenes start anew when a slider is let go of, not while it moves.
void chooseBreaking(ViewerState& state) {
    Choices& choices = state.choices;
    state.reload |= chooseName("material", choices.material, materialNames(), "as the scene says");
    ImGui::SliderFloat("strength", &choices.strength_factor, 0.1f, 10, "x %.2f",
                       ImGuiSliderFlags_Logarithmic);
    state.reload |= ImGui::IsItemDeactivatedAfterEdit();
    state.reload |= chooseEnum("quality", choices.quality);
    state.restart |= chooseEnum("guide field", choices.guide);
    int count = choices.fragment_count.value_or(0);
    if (ImGui::SliderInt("fragments", &count, 0, 36, count > 0 ? "%d" : "by energy"))
        choices.fragment_count = count;
    state.restart |= ImGui::IsItemDeactivatedAfterEdit();
    if (ImGui::Button("other cracks")) {
        ++choices.seed;
        state.restart = true;
    }
}

void chooseTime(ViewerState& state) {
    if (ImGui::Button(state.paused ? "go on" : "pause", ImVec2(62, 0))) state.paused = !state.paused;
    ImGui::SameLine();
    if (ImGui::Button("step")) state.step_once = state.paused = true;
    ImGui::SameLine();
    if (ImGui::Button("again")) state.restart = true;
    ImGui::SameLine();
    ImGui::Checkbox("follow", &state.follow);
    ImGui::SliderFloat("time", &state.speed, 0.01f, 2, "x %.2f", ImGuiSliderFlags_Logarithmic);
    float speed = float(state.throwing.speed_m_s), diameter = 100 * float(state.throwing.ball_diameter_m);
    ImGui::SliderFloat("ball speed", &speed, 1, 60, "%.0f m/s", ImGuiSliderFlags_Logarithmic);
    ImGui::SliderFloat("ball size", &diameter, 1, 40, "%.0f cm", ImGuiSliderFlags_Logarithmic);
    state.throwing = {speed, diameter / 100};
}

void chooseBudget(ViewerState& state) {
    ImGui::Checkbox("blows on fragments wait", &state.budget.limited);
    if (!state.budget.limited) return;
    ImGui::SliderFloat("a step", &state.budget.milliseconds_per_step, 0.5f, 30, "%.1f ms");
    ImGui::SliderInt("blows a step", &state.budget.solves_per_step, 1, 16);
}

void chooseOverlays(Overlays& overlays) {
    const char* const colours[] = {"hidden", "plain", "principal stress", "damage", "pieces"};
    int by = int(overlays.particles);
    if (ImGui::Combo("particles", &by, colours, IM_ARRAYSIZE(colours)))
        overlays.particles = ParticleColour(by);
    ImGui::Checkbox("pieces in colours", &overlays.coloured_pieces);
    ImGui::Checkbox("contacts", &overlays.contacts);
    ImGui::SameLine();
    ImGui::Checkbox("collision shapes", &overlays.collision_shapes);
}

void showKeys() {
    ImGui::TextDisabled(
        "click: throw   drag: turn   right or G: hold\nshift or middle: move   wheel: nearer\nspace: pause   "
        "N: "
        "step   R: again   S: slow\nF: look at it   C: colours   H: panels\nP: picture   V: a picture each "
        "frame");
}

}  // namespace

void drawScenePanel(ViewerState& state, const std::vector<std::string>& scene_files) {
    ImGui::SetNextWindowPos(ImVec2(12, 12), ImGuiCond_FirstUseEver);
    ImGui::Begin("Sherd", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushItemWidth(170);
    chooseScene(state, scene_files);
    chooseBreaking(state);
    ImGui::Separator();
    chooseTime(state);
    ImGui::Separator();
    chooseBudget(state);
    ImGui::Separator();
    chooseOverlays(state.overlays);
    ImGui::Separator();
    showKeys();
    ImGui::PopItemWidth();
    ImGui::End();
}

}  // namespace demo
