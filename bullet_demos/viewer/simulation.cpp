#include "viewer/simulation.h"

#include <chrono>
#include <utility>

namespace demo {
namespace {

double nowMs() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

Simulation& owner(btDynamicsWorld* world) {
    return *static_cast<Simulation*>(world->getWorldUserInfo());
}

}  // namespace

Simulation::Simulation(const Scene& scene, const SceneAssets& assets) : scene_(scene), world_(scene, assets) {
    world().setInternalTickCallback(beforeStep, this, true);
    world().setInternalTickCallback(afterStep, this, false);
}

void Simulation::advance(double seconds) {
    // After a long step the picture falls behind, rather than the steps run after the clock.
    constexpr int most_steps = 12;
    world().stepSimulation(btScalar(seconds), most_steps, btScalar(scene_.time_step_s));
    takeEvents();
}

void Simulation::stepOnce() {
    world_.step();
    takeEvents();
}

void Simulation::setBudget(const BudgetChoice& choice) {
    sherd::Budget budget = sherd::Budget::none();
    if (choice.limited) {
        budget = sherd::Budget();
        budget.milliseconds_per_step = choice.milliseconds_per_step;
        budget.solves_per_step = choice.solves_per_step;
    }
    (void)placed().fracture().setBudget(budget);  // the panel keeps to what is possible
}

void Simulation::throwBall(const render::Ray& ray, const Throw& how) {
    demo::throwBall(world(), placed(), ray, how);
}

void Simulation::takeEvents() {
    for (sherd::BlowEvent& event : placed().fracture().takeEvents()) {
        for (const btTypedConstraint* joint : event.removed_constraints) drag_.forget(joint);
        const bool broke = event.outcome == sherd::Outcome::broke;
        breaks_ += broke;
        if (event.outcome == sherd::Outcome::failed && failures_++ == 0) first_failure_ = event.message;
        if (broke) last_break_step_ = steps_;
        // One that held, or was torn out of its supports, says less than the break before it.
        const bool says_little = !broke || event.level == sherd::Level::gate;
        if (says_little && last_blow_ && last_blow_->event.outcome == sherd::Outcome::broke) continue;
        SeenBlow blow{std::move(event), {}, ++blows_};
        for (const btRigidBody* piece : blow.event.fragments)
            if (const auto* asset = placed().fracture().asset(piece)) blow.pieces.push_back(*asset);
        last_blow_ = std::move(blow);
    }
}

void Simulation::beforeStep(btDynamicsWorld* world, btScalar) {
    Simulation& self = owner(world);
    self.step_began_ms_ = nowMs();
    self.sherd_began_ms_ = self.placed().fracture().times().whole;
}

void Simulation::afterStep(btDynamicsWorld* world, btScalar) {
    constexpr std::size_t most_kept = 360;
    Simulation& self = owner(world);
    ++self.steps_;
    self.step_times_.push_back({float(nowMs() - self.step_began_ms_),
                                float(self.placed().fracture().times().whole - self.sherd_began_ms_)});
    if (self.step_times_.size() > most_kept) self.step_times_.pop_front();
}

}  // namespace demo
