#include "bullet/world/solver_decorator.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "bullet/world/world_internals.h"

namespace sherd {

SolverDecorator::SolverDecorator(btDiscreteDynamicsWorld& world, StepListener& listener)
    : world_(world),
      listener_(listener),
      inner_(world.getConstraintSolver()),
      world_owned_inner_(WorldInternals::ownsSolver(world)),
      inner_decorator_(dynamic_cast<SolverDecorator*>(inner_)) {
    if (inner_decorator_) inner_decorator_->outer_decorator_ = this;
    // Otherwise setConstraintSolver would free the solver that this one forwards to.
    WorldInternals::ownsSolver(world_) = false;
    world_.setConstraintSolver(this);
}

SolverDecorator::~SolverDecorator() {
    if (inner_decorator_) inner_decorator_->outer_decorator_ = outer_decorator_;
    if (outer_decorator_) {  // from now on it forwards to the solver that this one forwarded to
        outer_decorator_->inner_ = inner_;
        outer_decorator_->inner_decorator_ = inner_decorator_;
        outer_decorator_->world_owned_inner_ = world_owned_inner_;
    } else if (world_.getConstraintSolver() == this) {
        world_.setConstraintSolver(inner_);
        WorldInternals::ownsSolver(world_) = world_owned_inner_;
    } else if (world_owned_inner_) {
        // The app has set another solver since. The world's own solver then belongs to nobody else and is
        // freed as the world would free it.
        inner_->~btConstraintSolver();
        btAlignedFree(inner_);
    }
}

bool SolverDecorator::inPlace() const {
    const SolverDecorator* outermost = this;
    while (outermost->outer_decorator_) outermost = outermost->outer_decorator_;
    return world_.getConstraintSolver() == outermost;
}

btConstraintSolver& SolverDecorator::innermost() const {
    return inner_decorator_ ? inner_decorator_->innermost() : *inner_;
}

std::vector<StepListener*> SolverDecorator::listenersFromInside() const {
    std::vector<StepListener*> listeners;
    if (inner_decorator_) listeners = inner_decorator_->listenersFromInside();
    listeners.push_back(&listener_);
    return listeners;
}

void SolverDecorator::forEachListener(const std::function<void(StepListener&)>& call) const {
    const SolverDecorator* outermost = this;
    while (outermost->outer_decorator_) outermost = outermost->outer_decorator_;
    for (StepListener* listener : outermost->listenersFromInside()) call(*listener);
}

void SolverDecorator::prepareSolve(int body_count, int manifold_count) {
    solving_ = true;
    listener_.beforeSolve();
    inner_->prepareSolve(body_count, manifold_count);
}

btScalar SolverDecorator::solveGroup(btCollisionObject** bodies, int body_count,
                                     btPersistentManifold** manifolds, int manifold_count,
                                     btTypedConstraint** constraints, int constraint_count,
                                     const btContactSolverInfo& info, btIDebugDraw* drawer,
                                     btDispatcher* dispatcher) {
    return inner_->solveGroup(bodies, body_count, manifolds, manifold_count, constraints, constraint_count,
                              info, drawer, dispatcher);
}

void SolverDecorator::allSolved(const btContactSolverInfo& info, btIDebugDraw* drawer) {
    inner_->allSolved(info, drawer);
    listener_.afterSolve(info, drawer);
    solving_ = false;
    // One that was put around this one since the solve began is not told of it.
    for (const SolverDecorator* outer = outer_decorator_; outer; outer = outer->outer_decorator_)
        if (outer->solving_) return;
    if (!inner_decorator_) return listener_.endSolve(info);  // as nearly always; may delete this
    for (StepListener* listener : listenersFromInside()) listener->endSolve(info);
}

void SolverDecorator::reset() {
    inner_->reset();
}

btConstraintSolverType SolverDecorator::getSolverType() const {
    // Worlds and apps cast a solver to the class that its type names, and this is none of them. Multi-body
    // worlds keep a second pointer to their solver and go on using that one.
    return btConstraintSolverType{};
}

}  // namespace sherd
