#pragma once

#include <vector>

#include "headless/scene_run.h"

namespace demo {

/// What one stage of the pipeline took over a run.
struct StageTotal {
    const char* name = "";
    int count = 0;        ///< blows that needed the stage, of those that have an event
    double total_ms = 0;  ///< of all blows
    double worst_ms = 0;  ///< of a single blow that has an event
};

/// All stages in the order of the pipeline.
std::vector<StageTotal> stageTotals(const SceneRun& run);

/// Assembling, factoring and solving of one blow.
double stressMilliseconds(const sherd::BlowEvent& blow);

/// The middle value; 0 of nothing.
double median(std::vector<double> values);

}  // namespace demo
