#include "headless/summary.h"

#include <cstdio>
#include <set>
#include <vector>

#include "headless/stage_times.h"

namespace demo {
namespace {

using nlohmann::ordered_json;

template <class... Values>
std::string line(const char* format, Values... values) {
    char buffer[256];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return std::string(buffer) + "\n";
}

std::string stageTable(const SceneRun& run, const ordered_json& ms) {
    std::string text = line("%-14s %6s %12s %12s", "stage", "count", "total ms", "worst ms");
    for (const StageTotal& stage : stageTotals(run)) {
        text += line("%-14s %6d %12.2f %12.2f", stage.name, stage.count, stage.total_ms, stage.worst_ms);
    }
    for (const auto& field : sherd::time_fields<sherd::StepTimes>)
        text += line("%-14s %6s %12.2f", field.name, "", run.times.steps.*field.value);
    const double steps = ms["steps_ms"], worst = ms["step_total_worst"], middle = ms["step_total_median"];
    text += line("%-14s %6s %12.2f   (%.1f %% of it in the stages above)", "all of Sherd", "",
                 run.times.whole, 100 * run.times.stages() / run.times.whole);
    return text + line("%-14s %6zu %12.2f %12.2f   (median %.3f)", "whole step", run.step_ms.size(), steps,
                       worst, middle);
}

std::string blowLines(const ordered_json& report) {
    const long long seen = report["blows_seen"], gate = report["blows_by_gate"],
                    coarse = report["blows_by_coarse"], reduced = report["blows_by_reduced"],
                    full = report["blows_by_full"];
    std::string text = line(
        "%-14s %6lld seen; decided by the gate %lld (%.1f %%), a coarse solve %lld, the reduced model "
        "%lld, a full solve %lld",
        "blows", seen, gate, seen > 0 ? 100.0 * static_cast<double>(gate) / static_cast<double>(seen) : 0.0,
        coarse, reduced, full);
    const double first = report["ms"]["first_blow_ms"], further = report["ms"]["further_blow_ms"];
    if (further > 0) {
        text += line("%-14s first blow %.2f ms, further blow on the same body %.2f ms (%.0f times less)",
                     "stress", first, further, first / further);
    }
    return text;
}

/// What events said, each sentence once.
std::string messages(const SceneRun& run) {
    std::set<std::string> said;
    std::string text;
    for (const TimedEvent& timed : run.events) {
        std::vector<std::string> sentences = timed.event.warnings;
        sentences.push_back(timed.event.message);
        for (const std::string& sentence : sentences)
            if (!sentence.empty() && said.insert(sentence).second) text += "note: " + sentence + "\n";
    }
    return text;
}

}  // namespace

std::string summarise(const SceneRun& run, const ordered_json& report) {
    std::string text = line("%s: %d -> %d bodies, %d -> %d triangles, %d particles",
                            report["scene"].get<std::string>().c_str(), report["bodies_before"].get<int>(),
                            report["bodies_after"].get<int>(), report["triangles_before"].get<int>(),
                            report["triangles_after"].get<int>(), report["particles"].get<int>());
    text += stageTable(run, report["ms"]) + blowLines(report);
    const double dropped_kg = report["dropped_mass_kg"];
    if (dropped_kg > 0) text += line("%-14s debris of %.3g kg, out of the world", "dropped", dropped_kg);
    text += line("%-14s mass %.1e, volume %.1e, momentum %.1e, residual %.1e", "errors",
                 report["mass_error_rel"].get<double>(), report["volume_error_rel"].get<double>(),
                 report["momentum_error_rel"].get<double>(), report["residual_rel"].get<double>());
    return text + messages(run);
}

}  // namespace demo
