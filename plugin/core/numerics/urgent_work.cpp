#include "core/numerics/urgent_work.h"

#include <atomic>

namespace sherd {

namespace {

std::atomic<int> urgent{0}, waiting{0};  // threads
thread_local bool gives_way = false;

}  // namespace

UrgentWork::UrgentWork() {
    ++urgent;
}

UrgentWork::~UrgentWork() {
    --urgent;
}

WaitsForAnother::WaitsForAnother() {
    ++waiting;
}

WaitsForAnother::~WaitsForAnother() {
    --waiting;
}

void giveWayToUrgentWork() {
    gives_way = true;
}

bool isToGiveWay() {
    return gives_way && urgent > 0 && waiting == 0;
}

}  // namespace sherd
