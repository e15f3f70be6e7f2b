#pragma once

#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>

class btDiscreteDynamicsWorld;
struct btContactSolverInfo;

namespace sherd {

/// Called before the constraints of a step are solved, and after, when impulses are valid and positions are
/// not integrated yet.
class StepListener {
  public:
    virtual ~StepListener() = default;
    virtual void beforeSolve() = 0;
    virtual void afterSolve(const btContactSolverInfo& info, btIDebugDraw* drawer) = 0;
};

/// Decorates a world's constraint solver: forwards every call and tells the listener. Has no state of its own
/// during a solve, so islands may be solved in parallel. The constructor installs it in the world, the
/// destructor puts the world's own solver back.
class SolverDecorator final : public btConstraintSolver {
  public:
    SolverDecorator(btDiscreteDynamicsWorld& world, StepListener& listener);
    ~SolverDecorator() override;
    SolverDecorator(const SolverDecorator&) = delete;
    SolverDecorator& operator=(const SolverDecorator&) = delete;

    btConstraintSolver& inner() const { return *inner_; }
    /// Whether the world still solves with this one, perhaps from within other decorators of the same kind.
    bool inPlace() const;

    void prepareSolve(int body_count, int manifold_count) override;
    btScalar solveGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                        int manifold_count, btTypedConstraint** constraints, int constraint_count,
                        const btContactSolverInfo& info, btIDebugDraw* drawer,
                        btDispatcher* dispatcher) override;
    void allSolved(const btContactSolverInfo& info, btIDebugDraw* drawer) override;
    void reset() override;
    btConstraintSolverType getSolverType() const override;

  private:
    btDiscreteDynamicsWorld& world_;
    StepListener& listener_;
    btConstraintSolver* inner_;
    bool world_owned_inner_;
};

}  // namespace sherd
