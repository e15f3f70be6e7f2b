#pragma once

#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>

#include <functional>
#include <vector>

class btCollisionObject;
class btDiscreteDynamicsWorld;
struct btContactSolverInfo;

namespace sherd {

/// Called before the constraints of a step are solved, and after, when impulses are valid and positions are
/// not integrated yet. A world may have several listeners; what they ask of each other is here, too.
class StepListener {
  public:
    virtual ~StepListener() = default;
    virtual void beforeSolve() = 0;
    /// May solve the step again with other bodies.
    virtual void afterSolve(const btContactSolverInfo& info, btIDebugDraw* drawer) = 0;
    /// Once every listener is through with that: the solve is final.
    virtual void endSolve(const btContactSolverInfo& info) = 0;

    /// Bodies came into the world in the course of `afterSolve`; they have their state from before the solve.
    virtual void bodiesEnter(const std::vector<btCollisionObject*>& bodies) = 0;
    virtual bool isBreakable(const btCollisionObject& object) const = 0;
    virtual bool isFragment(const btCollisionObject& object) const = 0;
    virtual void deleteIfReleased() = 0;
};

/// Decorates a world's constraint solver: forwards every call and tells the listener. Keeps nothing of the
/// islands during a solve, so they may be solved in parallel. The constructor installs it in the world,
/// around those that are there already; the destructor takes it out, and the last one puts the world's own
/// solver back.
class SolverDecorator final : public btConstraintSolver {
  public:
    SolverDecorator(btDiscreteDynamicsWorld& world, StepListener& listener);
    ~SolverDecorator() override;
    SolverDecorator(const SolverDecorator&) = delete;
    SolverDecorator& operator=(const SolverDecorator&) = delete;

    bool isFirst() const { return !inner_decorator_; }
    /// The world's own solver.
    btConstraintSolver& innermost() const;
    /// Of this decorator and all those within and around it, the innermost first. A listener may be deleted
    /// when it is called.
    void forEachListener(const std::function<void(StepListener&)>& call) const;
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
    std::vector<StepListener*> listenersFromInside() const;

    btDiscreteDynamicsWorld& world_;
    StepListener& listener_;
    btConstraintSolver* inner_;
    bool world_owned_inner_;
    SolverDecorator* inner_decorator_;  // the same as inner_, or null if that is none
    SolverDecorator* outer_decorator_ = nullptr;
    bool solving_ = false;  // between prepareSolve and allSolved
};

}  // namespace sherd
