#pragma once

#include <LinearMath/btTransform.h>

#include <vector>

class btCollisionObject;
class btConstraintSolver;
class btDiscreteDynamicsWorld;
class btIDebugDraw;
class btMultiBody;
class btMultiBodyConstraint;
class btPersistentManifold;
class btTypedConstraint;
struct btContactSolverInfo;

namespace sherd {

/// How an object moved when the solver was about to run.
struct BodyState {
    const btCollisionObject* object = nullptr;
    btTransform transform;
    btVector3 linear = btVector3(0, 0, 0), angular = btVector3(0, 0, 0);

    btVector3 velocityAt(const btVector3& world_point) const {
        return linear + angular.cross(world_point - transform.getOrigin());
    }
};

/// A group of bodies that push each other directly or through others, with what joins them. The order is the
/// world's.
struct Island {
    std::vector<btCollisionObject*> bodies;  ///< dynamic rigid bodies and links of multi-bodies
    std::vector<btPersistentManifold*> manifolds;
    std::vector<btTypedConstraint*> constraints;
    std::vector<btMultiBody*> multi_bodies;
    std::vector<btMultiBodyConstraint*> multi_body_constraints;
};

/// What a solve changes, kept from before it.
class StepSnapshot {
  public:
    void take(btDiscreteDynamicsWorld& world);
    /// nullptr for objects that were not in the world, or cannot move.
    const BodyState* find(const btCollisionObject* object) const;
    /// Puts an island back to before the solve: velocities, transforms (split impulses move them), impulses
    /// that warm the solver up, joints that the solve broke, and what multi-bodies were about to get.
    void restore(const Island& island) const;

  private:
    struct PointImpulses {
        btScalar normal, lateral_1, lateral_2;
    };
    struct ManifoldState {
        const btPersistentManifold* manifold;
        std::size_t first_point;
        int point_count;
    };
    struct ConstraintState {
        const btTypedConstraint* constraint;
        bool enabled;
        btScalar applied_impulse;
    };
    void restorePoints(btPersistentManifold& manifold) const;
    void restoreConstraint(btTypedConstraint& constraint) const;

    std::vector<BodyState> bodies_;         // as in the world's array of objects
    std::vector<ManifoldState> manifolds_;  // as in the dispatcher's array
    std::vector<PointImpulses> points_;
    std::vector<ConstraintState> constraints_;
};

/// The islands that `seeds` belong to, as one, by the contacts and joints that there are now.
Island connectedIsland(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& seeds);

/// Solves one island with the solver that the world itself would use.
void solveIsland(btDiscreteDynamicsWorld& world, btConstraintSolver& solver, Island& island,
                 const btContactSolverInfo& info, btIDebugDraw* drawer);

}  // namespace sherd
