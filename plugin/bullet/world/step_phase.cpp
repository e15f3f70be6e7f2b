#include "bullet/world/step_phase.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <stdexcept>
#include <utility>

#include "bullet/world/world_internals.h"

namespace sherd {

namespace {

// Bullet sets the step count to 0 when a step begins and never reads it, so another value marks that the step
// is over.
constexpr int inside = 0, between = 1;

void refuseStep(btDynamicsWorld*, btScalar) {
    throw std::logic_error("stepSimulation must not be called from a FragmentCallback");
}

}  // namespace

bool isInsideStep(const btDiscreteDynamicsWorld& world) {
    return world.getDispatchInfo().m_stepCount != between;
}

void markBetweenSteps(btDiscreteDynamicsWorld& world) {
    world.getDispatchInfo().m_stepCount = between;
}

InsideStep::InsideStep(btDiscreteDynamicsWorld& world)
    : world_(world), before_(world.getDispatchInfo().m_stepCount) {
    world_.getDispatchInfo().m_stepCount = inside;
}

InsideStep::~InsideStep() {
    world_.getDispatchInfo().m_stepCount = before_;
}

NoStepMeanwhile::NoStepMeanwhile(btDiscreteDynamicsWorld& world)
    : world_(world), of_the_app_(std::exchange(WorldInternals::beforeSteps(world), &refuseStep)) {}

NoStepMeanwhile::~NoStepMeanwhile() {
    btInternalTickCallback& now = WorldInternals::beforeSteps(world_);
    if (now == &refuseStep) now = of_the_app_;  // else the app has set another one meanwhile
}

IntegrationHook::IntegrationHook(btDiscreteDynamicsWorld& world, IntegrationListener& listener)
    : world_(world), listener_(listener) {
    world_.addAction(this);
    auto& actions = WorldInternals::actions(world_);
    for (int i = actions.size() - 1; i > 0; --i) actions.swap(i, i - 1);
}

IntegrationHook::~IntegrationHook() {
    auto& actions = WorldInternals::actions(world_);
    const int place = actions.findLinearSearch(this);
    if (place == actions.size()) return;  // the app removed it
    for (int i = place; i + 1 < actions.size(); ++i) actions.swap(i, i + 1);
    actions.pop_back();
}

}  // namespace sherd
