#include "bullet/schedule/solvers_ahead.h"

#include <algorithm>
#include <iterator>
#include <thread>

#include "bullet/bodies/decided_blow.h"
#include "bullet/schedule/waiting_blows.h"
#include "core/numerics/job.h"
#include "core/numerics/worker_threads.h"
#include "fracture/breakable_solid.h"

namespace sherd {

namespace {

bool isWorthIt(const Breakable& fragment) {
    constexpr double much_ms = 40;  // of one core of about 2020
    const BreakableSolid& solid = *fragment.asset.solid();
    return fragment.mayBreak() && estimatedMilliseconds(solid, {}) > much_ms &&
           mayRunElsewhere(solid, *fragment.fracture);
}

/// What is held stays where the next ball comes; of the others the heavier ones.
bool isSooner(const Breakable* a, const Breakable* b) {
    return a->isHeld() != b->isHeld() ? a->isHeld() : a->asset.mass() > b->asset.mass();
}

/// A thread of their own: those of an executor have blows to decide that are due.
Executor ownThread() {
    return std::thread::hardware_concurrency() > 1 ? patientWorkerThreads(GivesWay::to_all, 1) : Executor();
}

/// An error of it is told by the blow that needs the stress problem.
std::shared_ptr<Job> jobFor(const std::shared_ptr<const BreakableSolid>& solid) {
    return Job::make([into = std::weak_ptr<const BreakableSolid>(solid)] {
        const auto wanted = into.lock();
        if (!wanted) return;
        try {
            (void)wanted->stressSolver();
            wanted->prepareSurface();
        } catch (...) {
        }
    });
}

}  // namespace

void SolversAhead::add(const std::shared_ptr<const BreakableSolid>& solid, bool may_have_thread) {
    solid->expectFactor();
    if (!may_have_thread) return;
    if (!thread_) thread_ = ownThread();
    jobFor(solid)->submit(thread_);
}

void SolversAhead::addFragments(const std::vector<Breakable*>& fragments, int most, bool may_have_thread) {
    std::vector<const Breakable*> large;
    std::copy_if(fragments.begin(), fragments.end(), std::back_inserter(large),
                 [](const Breakable* fragment) { return isWorthIt(*fragment); });
    std::stable_sort(large.begin(), large.end(), isSooner);
    large.resize(std::min(large.size(), static_cast<std::size_t>(most)));
    for (const Breakable* fragment : large) add(fragment->asset.solid(), may_have_thread);
}

void SolversAhead::addStruckSoon(const Breakable& body, double time_s, bool may_have_thread) {
    constexpr std::size_t most = 3;
    if (body.isFragment() || body.asset.solid()->hasSolver()) return;
    const auto is_past = [&](double taken_s) { return taken_s + 1 <= time_s; };
    struck_soon_s_.erase(std::remove_if(struck_soon_s_.begin(), struck_soon_s_.end(), is_past),
                         struck_soon_s_.end());
    if (struck_soon_s_.size() == most) return;
    struck_soon_s_.push_back(time_s);
    add(body.asset.solid(), may_have_thread);
}

}  // namespace sherd
