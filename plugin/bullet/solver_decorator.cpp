#include "bullet/solver_decorator.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "bullet/world_internals.h"

namespace sherd {

SolverDecorator::SolverDecorator(btDiscreteDynamicsWorld& world, StepListener& listener)
    : world_(world),
      listener_(listener),
      inner_(world.getConstraintSolver()),
      world_owned_inner_(WorldInternals::ownsSolver(world)) {
    // Otherwise setConstraintSolver would free the solver that this one forwards to.
    WorldInternals::ownsSolver(world_) = false;
    world_.setConstraintSolver(this);
}

SolverDecorator::~SolverDecorator() {
    // Another decorator may be around this one: from now on it forwards to the solver that this one forwarded
    // to.
    for (auto* outer = dynamic_cast<SolverDecorator*>(world_.getConstraintSolver()); outer;
         outer = dynamic_cast<SolverDecorator*>(outer->inner_)) {
        if (outer->inner_ != this) continue;
        outer->inner_ = inner_;
        outer->world_owned_inner_ = world_owned_inner_;
        return;
    }
    if (world_.getConstraintSolver() == this) {
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
    for (auto* solver = dynamic_cast<SolverDecorator*>(world_.getConstraintSolver()); solver;
         solver = dynamic_cast<SolverDecorator*>(solver->inner_))
        if (solver == this) return true;
    return false;
}

void SolverDecorator::prepareSolve(int body_count, int manifold_count) {
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
}

void SolverDecorator::reset() {
    inner_->reset();
}

btConstraintSolverType SolverDecorator::getSolverType() const {
    // A world that reads BT_MULTIBODY_SOLVER here casts this object to btMultiBodyConstraintSolver, which it
    // is not. Multi-body worlds keep a second pointer to their solver and go on using that one.
    const btConstraintSolverType type = inner_->getSolverType();
    return type == BT_MULTIBODY_SOLVER ? BT_SEQUENTIAL_IMPULSE_SOLVER : type;
}

}  // namespace sherd
