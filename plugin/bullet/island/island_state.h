#pragma once

#include <LinearMath/btTransform.h>

#include <vector>

class btCollisionObject;
class btConstraintSolver;
class btDiscreteDynamicsWorld;
class btIDebugDraw;
class btMultiBody;
class btMultiBodyConstraint;
class btManifoldPoint;
class btPersistentManifold;
class btTypedConstraint;
struct btContactSolverInfo;

namespace sherd {

/// Transform and velocities of an object just before the solve.
struct BodyState {
    const btCollisionObject* object = nullptr;
    btTransform transform;
    btVector3 linear = btVector3(0, 0, 0), angular = btVector3(0, 0, 0);

    btVector3 velocityAt(const btVector3& world_point) const {
        return linear + angular.cross(world_point - transform.getOrigin());
    }
};

/// A simulation island: bodies connected by contacts or joints, directly or through other bodies, and these
/// contacts and joints. Each list is in the order of the world's own array.
struct Island {
    std::vector<btCollisionObject*> bodies;  ///< dynamic rigid bodies and links of multi-bodies
    std::vector<btPersistentManifold*> manifolds;
    std::vector<btTypedConstraint*> constraints;
    std::vector<btMultiBody*> multi_bodies;
    std::vector<btMultiBodyConstraint*> multi_body_constraints;
};

/// A copy, made before the solve, of all that the solve changes.
class StepSnapshot {
  public:
    void take(btDiscreteDynamicsWorld& world);
    /// Of the objects only: for steps in which nothing is restored.
    void takeBodies(const btDiscreteDynamicsWorld& world);
    void clear();
    /// Adds bodies that came into the world since, as they stand and move now.
    void add(const std::vector<btCollisionObject*>& objects);
    /// nullptr for objects that were not in the world then, nor added.
    const BodyState* find(const btCollisionObject* object) const;
    /// Resets an island to its state before the solve: velocities, transforms (split impulses change them),
    /// the impulses for warm starting, joints that the solve broke, and the pending velocities of
    /// multi-bodies. Contacts that are new since have no impulses.
    void restore(const Island& island) const;

  private:
    struct PointImpulses {
        btVector3 local_a, local_b;  // of the point: the manifold may hold others since, in another order
        btScalar normal = 0, lateral_1 = 0, lateral_2 = 0;
    };
    /// Manifolds come from a pool: one that was made since may have the address of one that is gone, but not
    /// its bodies.
    struct ManifoldState {
        const btPersistentManifold* manifold;
        const btCollisionObject *body_a, *body_b;
        std::size_t first_point;
        int point_count;
    };
    struct ConstraintState {
        const btTypedConstraint* constraint;
        bool enabled;
        btScalar applied_impulse;
    };
    void addBody(const btCollisionObject& object);
    void restorePoints(btPersistentManifold& manifold) const;
    const PointImpulses* find(const ManifoldState& state, int likely_place,
                              const btManifoldPoint& point) const;
    void restoreConstraint(btTypedConstraint& constraint) const;

    std::vector<BodyState> bodies_;         // in the order of the world's array of objects
    std::vector<int> proxies_;              // of these: unique ids, which no object gets that is added since
    std::vector<ManifoldState> manifolds_;  // in the order of the dispatcher's array
    std::vector<PointImpulses> points_;
    std::vector<ConstraintState> constraints_;
};

/// The union of the islands of `seeds`, by the present contacts and joints.
Island connectedIsland(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& seeds);

/// Solves one island with the solver, and the method of it, that the world itself would use.
void solveIsland(btDiscreteDynamicsWorld& world, btConstraintSolver& solver, Island& island,
                 const btContactSolverInfo& info, btIDebugDraw* drawer);

}  // namespace sherd
