#include "headless/report.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "headless/stage_times.h"

namespace demo {
namespace {

using nlohmann::ordered_json;
using sherd::BlowEvent;
using sherd::Outcome;

/// Of all breakable bodies together.
struct Totals {
    int bodies = 0;
    std::size_t triangles = 0;
    double mass_kg = 0, volume_m3 = 0;
};

Totals totals(const std::vector<BodyState>& states) {
    Totals sum;
    for (const BodyState& state : states) {
        if (!state.asset) continue;
        ++sum.bodies;
        sum.triangles += state.asset->surface().triangles.size();
        sum.mass_kg += state.asset->mass();
        sum.volume_m3 += state.asset->volume();
    }
    return sum;
}

/// Largest of one figure over all blows.
double worst(const SceneRun& run, double BlowEvent::*figure) {
    double most = 0;
    for (const TimedEvent& timed : run.events) most = std::max(most, timed.event.*figure);
    return most;
}

double droppedMass(const SceneRun& run) {
    double sum_kg = 0;
    for (const TimedEvent& timed : run.events) sum_kg += timed.event.dropped_mass_kg;
    return sum_kg;
}

double difference(double is, double was) {
    return was > 0 ? std::abs(is - was) / was : 0;
}

/// What it took up to the first break: the sampling, the stress (with assembling and factoring) and the
/// making of fragments. Null if nothing broke.
ordered_json firstBreakMilliseconds(const SceneRun& run, double sample_ms) {
    double matrix = 0;
    for (const TimedEvent& timed : run.events) {
        const sherd::StageTimes& ms = timed.event.ms;
        matrix += ms.assemble + ms.factor;
        if (timed.event.outcome != Outcome::broke) continue;
        return {{"sample", sample_ms},
                {"stress", matrix + ms.loads + ms.solve + ms.stress},
                {"fragmentation", ms.damage + ms.cluster + ms.surface + ms.fragments}};
    }
    return nullptr;
}

/// Of the first blow that was solved; 0 if none was.
double firstBlowMilliseconds(const SceneRun& run) {
    for (const TimedEvent& timed : run.events)
        if (timed.event.level > sherd::Level::gate) return stressMilliseconds(timed.event);
    return 0;
}

ordered_json milliseconds(const SceneRun& run, double sample_ms, const FurtherBlows& further_blows) {
    ordered_json ms;
    for (const StageTotal& stage : stageTotals(run)) ms[stage.name] = stage.total_ms;
    for (const auto& field : sherd::time_fields<sherd::StepTimes>)
        ms[field.name] = run.times.steps.*field.value;
    // What the steps took: in all, of that Sherd's part, all stages above together, Bullet's own solve.
    ms["steps_ms"] = std::accumulate(run.step_ms.begin(), run.step_ms.end(), 0.0);
    ms["ours_ms"] = run.times.whole;
    ms["stages_ms"] = run.times.stages();
    ms["bullet_solve_ms"] = run.times.bullet_solve;
    ms["first_break"] = firstBreakMilliseconds(run, sample_ms);
    ms["step_total_worst"] =
        run.step_ms.empty() ? 0 : *std::max_element(run.step_ms.begin(), run.step_ms.end());
    ms["step_total_median"] = median(run.step_ms);
    std::vector<double> further;
    for (const BlowEvent& blow : further_blows) further.push_back(stressMilliseconds(blow));
    ms["first_blow_ms"] = firstBlowMilliseconds(run);
    ms["further_blow_ms"] = median(further);
    return ms;
}

ordered_json describe(const TimedEvent& timed) {
    const BlowEvent& event = timed.event;
    const auto list = [](const Vec3& v) { return ordered_json::array({v.x(), v.y(), v.z()}); };
    ordered_json entry;
    entry["time_s"] = timed.time_s;
    entry["outcome"] = sherd::nameOf(event.outcome);
    entry["level"] = sherd::nameOf(event.level);
    if (event.full_solve_outcome) {
        entry["full_solve_outcome"] = sherd::nameOf(*event.full_solve_outcome);
        entry["full_solve_largest_stress_pa"] = event.full_solve_largest_stress_pa;
    }
    entry["fragments"] = event.fragments.size();
    entry["crack_area_m2"] = event.crack_area_m2;
    entry["position_m"] = list(event.position);
    entry["normal"] = list(event.normal);
    entry["impulse_n_s"] = event.impulse_n_s;
    entry["peak_force_n"] = event.peak_force_n;
    entry["contact_time_s"] = event.contact_time_s;
    entry["largest_stress_pa"] = event.largest_stress_pa;
    entry["dropped_mass_kg"] = event.dropped_mass_kg;
    entry["message"] = event.message;
    entry["warnings"] = event.warnings;
    return entry;
}

}  // namespace

ordered_json makeReport(const Scene& scene, const SceneAssets& assets, const SceneRun& run,
                        const FurtherBlows& further_blows) {
    const Totals before = totals(run.before), broken = totals(run.broken), after = totals(run.after);
    ordered_json report;
    report["scene"] = scene.name;
    report["seed"] = scene.bodies.empty() ? 0 : scene.bodies.front().settings.fracture.seed;
    report["bodies"] = ordered_json::array();
    for (const BreakableBody& body : scene.bodies)
        report["bodies"].push_back({{"material", ordered_json::parse(body.material.toJson())},
                                    {"settings", ordered_json::parse(body.settings.toJson())}});
    int particles = 0;
    for (const sherd::BreakableAsset& asset : assets.bodies) particles += asset.particleCount();
    report["particles"] = particles;
    report["triangles_before"] = before.triangles;
    report["triangles_after"] = after.triangles;
    report["bodies_before"] = before.bodies;
    report["bodies_after_first_break"] = broken.bodies;
    report["triangles_after_first_break"] = broken.triangles;
    report["bodies_after"] = after.bodies;
    report["blows_seen"] = run.counts.seen;
    for (const auto& level : sherd::enum_names<sherd::Level>)
        report[std::string("blows_by_") + level.name] = run.counts.at(level.value);
    report["first_break_s"] = run.first_break_s;
    report["largest_stress_pa"] = worst(run, &BlowEvent::largest_stress_pa);
    // Over each swap, and from the start to the end: pieces that got lost later would show in the second. Of
    // debris that was dropped the mass is known, the volume is not.
    const double dropped_kg = droppedMass(run);
    report["dropped_mass_kg"] = dropped_kg;
    report["mass_error_rel"] = std::max(worst(run, &BlowEvent::mass_error_rel),
                                        difference(after.mass_kg + dropped_kg, before.mass_kg));
    report["volume_error_rel"] = std::max(worst(run, &BlowEvent::volume_error_rel),
                                          dropped_kg > 0 ? 0 : difference(after.volume_m3, before.volume_m3));
    report["momentum_error_rel"] = worst(run, &BlowEvent::momentum_error_rel);
    report["residual_rel"] = worst(run, &BlowEvent::residual_rel);
    report["events"] = ordered_json::array();
    for (const TimedEvent& timed : run.events) report["events"].push_back(describe(timed));
    report["ms"] = milliseconds(run, assets.sample_ms, further_blows);
    return report;
}

}  // namespace demo
