#include "headless/stage_times.h"

#include <algorithm>

namespace demo {

std::vector<StageTotal> stageTotals(const SceneRun& run) {
    std::vector<StageTotal> totals;
    for (const auto& stage : sherd::time_fields<sherd::StageTimes>) {
        StageTotal total{stage.name};
        total.total_ms = run.times.blows.*stage.value;
        for (const TimedEvent& timed : run.events) {
            const double ms = timed.event.ms.*stage.value;
            total.count += ms > 0;
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
