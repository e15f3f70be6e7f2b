#include "headless/scene_run.h"

#include <chrono>
#include <cmath>
#include <string>

namespace demo {
namespace {

using sherd::Outcome;

constexpr double impact_picture_s =
    0.03;  ///< after the first break: long enough for the pieces to come apart

int stepCount(const Scene& scene) {
    return static_cast<int>(std::lround(scene.duration_s / scene.time_step_s));
}

double timedStep(SceneWorld& world) {
    const auto start = std::chrono::steady_clock::now();
    world.step();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

std::string describe(const SceneRun& run, SceneWorld& world) {
    const sherd::BlowCounts counts = world.fracture().counts();
    const std::size_t bodies = world.fracture().bodies().size();
    return std::to_string(bodies) + (bodies == 1 ? " body" : " bodies") +
           "; blows: " + std::to_string(counts.seen) + " seen, " + std::to_string(counts.solved()) +
           " solved" +
           (run.first_break_s < 0 ? ""
                                  : "; broke at " + std::to_string(run.first_break_s).substr(0, 5) + " s");
}

/// Takes over what happened in the last step, which ended at `time_s`.
void collectEvents(SceneRun& run, SceneWorld& world, Recorder& recorder, double time_s) {
    std::vector<sherd::BlowEvent> events = world.fracture().takeEvents();
    recorder.record(time_s, events);
    for (sherd::BlowEvent& event : events) {
        if (event.outcome == Outcome::broke && run.first_break_s < 0) run.first_break_s = time_s;
        run.events.push_back({time_s, std::move(event)});
    }
}

}  // namespace

SceneRun runScene(const Scene& scene, const SceneAssets& assets, Progress& progress) {
    SceneWorld world(scene, assets);
    SceneRun run;
    Recorder recorder(world.placed());
    recorder.record(0, {});
    const std::vector<BodyState> start = world.states();
    const int steps = stepCount(scene);
    for (int step = 1; step <= steps; ++step) {
        const double time_s = step * scene.time_step_s;
        if (run.first_break_s < 0) run.before = world.states();
        run.step_ms.push_back(timedStep(world));
        collectEvents(run, world, recorder, time_s);
        if (run.first_break_s >= 0 && run.broken.empty()) run.broken = world.states();
        if (run.first_break_s >= 0) {
            const double since_break_s = time_s - run.first_break_s;
            if (run.impact.empty() && since_break_s >= impact_picture_s) run.impact = world.states();
            if (run.shown.empty() && scene.after_picture_s > 0 && since_break_s >= scene.after_picture_s)
                run.shown = world.states();
        }
        progress.show(static_cast<double>(step) / steps, describe(run, world));
    }
    if (run.first_break_s < 0) run.before = start;
    run.after = world.states();
    if (run.shown.empty()) run.shown = run.after;
    run.tracks = recorder.tracks();
    run.counts = world.fracture().counts();
    run.times = world.fracture().times();
    return run;
}

std::optional<sherd::BlowEvent> strikeAgain(const Scene& scene, const SceneAssets& assets) {
    SceneWorld world(scene, assets);
    for (int step = 0; step < stepCount(scene); ++step) {
        world.step();
        for (sherd::BlowEvent& event : world.fracture().takeEvents())
            if (event.level > sherd::Level::gate) return std::move(event);
    }
    return std::nullopt;
}

}  // namespace demo
