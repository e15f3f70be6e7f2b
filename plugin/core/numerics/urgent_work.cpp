#include "core/numerics/urgent_work.h"

#include <atomic>
#include <optional>
#include <thread>

namespace sherd {

namespace {

std::atomic<int> urgent{0}, waiting{0}, busy{0};  // threads
thread_local int urgent_here = 0;
thread_local std::optional<GivesWay> gives_way;

bool isAnyCoreLeft() {
    static const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return busy < cores - 1;
}

}  // namespace

UrgentWork::UrgentWork() {
    ++urgent;
    ++urgent_here;
}

UrgentWork::~UrgentWork() {
    --urgent;
    --urgent_here;
}

bool isUrgentHere() {
    return urgent_here > 0;
}

WaitsForAnother::WaitsForAnother() {
    ++waiting;
}

WaitsForAnother::~WaitsForAnother() {
    --waiting;
}

void giveWay(GivesWay to) {
    gives_way = to;
}

BusyThread::BusyThread() : counts_(gives_way == GivesWay::to_urgent) {
    busy += counts_;
}

BusyThread::~BusyThread() {
    busy -= counts_;
}

bool isToGiveWay() {
    return gives_way && waiting == 0 && (urgent > 0 || (gives_way == GivesWay::to_all && !isAnyCoreLeft()));
}

}  // namespace sherd
