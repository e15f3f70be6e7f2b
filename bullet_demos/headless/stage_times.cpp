#include "headless/stage_times.h"

#include <algorithm>

namespace demo {
namespace {

using sherd::StageTimes;

struct Stage {
    const char* name;
    double StageTimes::*time;
};

constexpr Stage stages[] = {
    {"sample", &StageTimes::sample},   {"assemble", &StageTimes::assemble},
    {"factor", &StageTimes::factor},   {"solve", &StageTimes::solve},
    {"stress", &StageTimes::stress},   {"damage", &StageTimes::damage},
    {"cluster", &StageTimes::cluster}, {"surface", &StageTimes::surface},
    {"bodies", &StageTimes::bodies},   {"resolve_step", &StageTimes::resolve_step},
};

}  // namespace

std::vector<StageTotal> stageTotals(const SceneRun& run) {
    std::vector<StageTotal> totals;
    for (const Stage& stage : stages) {
        StageTotal total{stage.name};
        for (const TimedEvent& timed : run.events) {
            const double ms = timed.event.ms.*(stage.time);
            total.count += ms > 0;
            total.total_ms += ms;
            total.worst_ms = std::max(total.worst_ms, ms);
        }
        totals.push_back(total);
    }
    return totals;
}

double stressMilliseconds(const sherd::BlowEvent& blow) {
    return blow.ms.assemble + blow.ms.factor + blow.ms.solve;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace demo
