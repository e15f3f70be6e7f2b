#include "viewer/blow_panel.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "viewer/panel_parts.h"

namespace demo {
namespace {

constexpr float width = 300;

void plotSteps(const std::deque<StepTime>& times, double step_s) {
    std::vector<float> whole;
    float largest = 0, sherd = 0;
    for (const StepTime& time : times) {
        whole.push_back(time.whole_ms);
        largest = std::max(largest, time.whole_ms);
        sherd += time.sherd_ms;
    }
    const float last = whole.empty() ? 0 : whole.back();
    ImGui::Text("step %.2f ms of %.1f, largest %.0f ms", double(last), 1000 * step_s, double(largest));
    ImGui::PlotLines("##steps", whole.data(), int(whole.size()), 0, nullptr, 0, std::max(largest, 1.0f),
                     ImVec2(width, 56));
    if (!times.empty()) ImGui::Text("Sherd's part %.3f ms on average", double(sherd / float(times.size())));
}

void showCounts(const sherd::BlowCounts& counts) {
    const double seen = std::max(1.0, double(counts.seen));
    ImGui::Text("blows seen %lld, the gate skips %.1f %%", counts.seen, 100 * double(counts.gate) / seen);
    ImGui::Text("coarse %lld   reduced %lld   full %lld", counts.coarse, counts.reduced, counts.full);
    ImGui::Text("foreseen %lld   in vain %lld", counts.foreseen, counts.foreseen_in_vain);
    ImGui::Text("waited %lld   merged %lld   dropped %lld", counts.waited, counts.merged, counts.dropped);
}

void showStages(const sherd::StageTimes& ms) {
    double longest = 0;
    for (const auto& stage : sherd::time_fields<sherd::StageTimes>)
        longest = std::max(longest, ms.*stage.value);
    for (const auto& stage : sherd::time_fields<sherd::StageTimes>) {
        const double taken = ms.*stage.value;
        if (taken <= 0) continue;
        char text[32];
        std::snprintf(text, sizeof text, "%.2f ms", taken);
        ImGui::Text("%-10s", stage.name);
        ImGui::SameLine(90);
        ImGui::ProgressBar(float(taken / longest), ImVec2(width - 82, 13), text);
    }
}

const char* decidedBy(sherd::Level level) {
    switch (level) {
        case sherd::Level::gate:
            return ", decided by the gate";
        case sherd::Level::coarse:
            return ", decided by a coarse solve";
        case sherd::Level::reduced:
            return ", decided by the reduced model";
        case sherd::Level::full:
            return ", decided by a full solve";
        case sherd::Level::none:
            break;
    }
    return "";
}

void showBlow(const sherd::BlowEvent& blow) {
    ImGui::Text("last blow: %s%s", sherd::nameOf(blow.outcome), decidedBy(blow.level));
    if (!blow.fragments.empty()) ImGui::Text("%zu pieces", blow.fragments.size());
    ImGui::Text("%.1f MPa at %.0f N over %.2f ms", blow.largest_stress_pa / 1e6, blow.peak_force_n,
                1000 * blow.contact_time_s);
    ImGui::Text("%.1f ms in all", blow.ms.total());
    showStages(blow.ms);
    if (!blow.message.empty()) ImGui::TextWrapped("%s", blow.message.c_str());
    for (const std::string& warning : blow.warnings) ImGui::TextWrapped("%s", warning.c_str());
}

}  // namespace

void drawBlowPanel(Simulation& simulation, render::Size size) {
    ImGui::SetNextWindowPos(ImVec2(float(size.width) - 12, 12), ImGuiCond_Always, ImVec2(1, 0));
    ImGui::Begin("Time", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushTextWrapPos(width + 10);
    plotSteps(simulation.stepTimes(), simulation.scene().time_step_s);
    ImGui::Text("%zu bodies after %d steps", simulation.placed().fracture().bodies().size(),
                simulation.steps());
    ImGui::Separator();
    showCounts(simulation.placed().fracture().counts());
    if (simulation.lastBlow()) {
        ImGui::Separator();
        showBlow(simulation.lastBlow()->event);
    }
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void drawColourBar(const BlowStress& stress, ParticleColour by, render::Size size) {
    ImGui::SetNextWindowPos(ImVec2(float(size.width) / 2, float(size.height) - 14), ImGuiCond_Always,
                            ImVec2(0.5f, 1));
    ImGui::Begin("##colours", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar);
    if (!stress.error.empty()) ImGui::TextWrapped("%s", stress.error.c_str());
    if (by == ParticleColour::damage)
        ImGui::Text("red: principal stress above the mean strength, %.1f MPa", stress.strength_pa / 1e6);
    if (by == ParticleColour::stress) {
        const double scale = stressScale(stress);
        ImGui::Text("largest principal stress of the last blow's peak force, MPa");
        const ImVec2 corner = ImGui::GetCursorScreenPos(), extent(360, 14);
        constexpr int steps = 60;
        for (int i = 0; i < steps; ++i) {
            const render::Vec3 c = stressColour((float(i) + 0.5f) / steps).cwiseSqrt();
            ImGui::GetWindowDrawList()->AddRectFilled(
                ImVec2(corner.x + extent.x * float(i) / steps, corner.y),
                ImVec2(corner.x + extent.x * float(i + 1) / steps, corner.y + extent.y),
                ImGui::GetColorU32(ImVec4(c.x(), c.y(), c.z(), 1)));
        }
        ImGui::Dummy(extent);
        ImGui::Text("0");
        for (int quarter = 1; quarter <= 4; ++quarter) {
            ImGui::SameLine(extent.x * float(quarter) / 4 - 14);
            ImGui::Text("%.1f", scale * quarter / 4 / 1e6);
        }
        ImGui::Text("mean strength %.1f MPa", stress.strength_pa / 1e6);
    }
    ImGui::End();
}

}  // namespace demo
