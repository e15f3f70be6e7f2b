#include "viewer/notices.h"

#include <imgui.h>

#include <cmath>

namespace demo {

void drawProgress(ViewerState& state, const std::string& what, float share, bool may_start,
                  render::Size size) {
    ImGui::SetNextWindowPos(ImVec2(float(size.width) / 2, float(size.height) * 0.5f), ImGuiCond_Always,
                            ImVec2(0.5f, 0.5f));
    ImGui::Begin("##progress", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar);
    ImGui::TextUnformatted(what.c_str());
    // Of unknown length: a bar that comes and goes.
    const float shown = share >= 0 ? share : 0.5f - 0.5f * std::cos(3 * float(ImGui::GetTime()));
    ImGui::ProgressBar(shown, ImVec2(340, 0), share >= 0 ? nullptr : "");
    if (may_start && ImGui::Button("start now; the first blows then take longer")) state.start_now = true;
    ImGui::End();
}

void drawNotices(ViewerState& state, render::Size size) {
    if (state.said.empty() && state.notice.empty()) return;
    ImGui::SetNextWindowPos(ImVec2(12, float(size.height) - 12), ImGuiCond_Always, ImVec2(0, 1));
    ImGui::Begin("##notices", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar);
    ImGui::PushTextWrapPos(float(size.width) * 0.55f);
    for (const std::string& sentence : state.said) ImGui::TextUnformatted(sentence.c_str());
    if (!state.notice.empty()) ImGui::TextUnformatted(state.notice.c_str());
    ImGui::PopTextWrapPos();
    if (ImGui::Button("close")) {
        state.said.clear();
        state.notice.clear();
    }
    ImGui::End();
}

}  // namespace demo
