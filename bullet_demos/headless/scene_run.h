#pragma once

#include <sherd/sherd.h>

#include <optional>
#include <vector>

#include "film/recording.h"
#include "headless/progress.h"
#include "scenes/scene.h"
#include "world/scene_world.h"

namespace demo {

/// A blow and when it fell. The body pointers of the event are not to be followed after the run.
struct TimedEvent {
    double time_s = 0;
    sherd::BlowEvent event;
};

/// What a run leaves.
struct SceneRun {
    std::vector<BodyState> before;  ///< the last moment before the first break; the start, if nothing broke
    std::vector<BodyState> broken;  ///< right after the first break; empty if nothing broke
    std::vector<BodyState> impact;  ///< a moment after the first break; empty if nothing broke
    std::vector<BodyState> shown;   ///< what after.png shows
    std::vector<BodyState> after;   ///< the end
    std::vector<Track> tracks;      ///< where everything was, from start to end
    std::vector<TimedEvent> events;
    sherd::BlowCounts counts;
    sherd::WorldTimes times;
    std::vector<double> step_ms;  ///< wall-clock time of every step
    double first_break_s = -1;    ///< simulated time; -1: nothing broke
};

/// Runs a scene from start to end.
SceneRun runScene(const Scene& scene, const SceneAssets& assets, Progress& progress);

/// The first solved blow of the scene, struck once more on the same assets: what a blow costs on a body that
/// is factored already. Nothing if no blow was solved within the scene's duration.
std::optional<sherd::BlowEvent> strikeAgain(const Scene& scene, const SceneAssets& assets);

}  // namespace demo
