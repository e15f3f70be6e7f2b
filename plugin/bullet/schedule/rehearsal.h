#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>
#include <unordered_map>
#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/fragments/birth_overlaps.h"
#include "bullet/ground/moved_ground.h"
#include "bullet/island/island_state.h"
#include "bullet/schedule/roles.h"
#include "bullet/shapes/piece_contacts.h"
#include "bullet/strikes/contact_collector.h"
#include "bullet/strikes/recent_strikes.h"
#include "bullet/world/impulse_write_back.h"
#include "bullet/world/solver_decorator.h"

namespace sherd {

/// Some bodies of a world, as they stand and move now, in a world of their own, which runs ahead of the
/// first: what will strike what, and how, as a step of the first will find it if nothing else comes between.
/// The bodies themselves are stand-ins with the same shapes. Nothing of the first world changes, and nothing
/// of the app's is called but its filters, of its own bodies (`mayRehearse`).
class Rehearsal final : private StepListener, private btOverlapFilterCallback {
  public:
    /// The roles are in the order of the world's array of objects.
    Rehearsal(btDiscreteDynamicsWorld& world, const BirthOverlaps& overlaps,
              const RecentStrikes& recent_strikes, const std::vector<Role>& roles, double time_s);

    /// Whether a rehearsal of the world finds what the world's own steps do, and calls nobody: the app hears
    /// of no contact, and has not set how Bullet combines two materials or looks for contacts.
    static bool mayRehearse(btDiscreteDynamicsWorld& world);

    /// Takes one step. Returns the blows of it, in terms of the world's own bodies.
    std::vector<StruckBreakable> step();
    /// What the last step cost, in steps of one body that touches nothing.
    int costOfStep() const {
        return static_cast<int>(original_of_.size()) + dispatcher_.getNumManifolds() / 2;
    }
    /// At the end of the last step; simulated time.
    double time() const { return time_s_; }
    /// Where the stand-in of a body is now.
    BodyState stateOf(const btRigidBody& body) const;

  private:
    /// The contacts that two bodies had at the end of the world's last step.
    struct KnownContacts {
        const btCollisionObject *a, *b;  // stand-ins
        std::vector<btManifoldPoint> points;
    };

    void beforeSolve() override;
    void afterSolve(const btContactSolverInfo& info, btIDebugDraw* drawer) override;
    void endSolve(const btContactSolverInfo& info) override;
    void bodiesEnter(const std::vector<btCollisionObject*>&) override {}
    bool isBreakable(const btCollisionObject& object) const override;
    bool isFragment(const btCollisionObject& object) const override;
    void deleteIfReleased() override {}
    bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;

    void add(const Role& role);
    void noteContacts(btDiscreteDynamicsWorld& world);
    void takeOverContacts();
    const btCollisionObject* original(const btCollisionObject* stand_in) const;

    btDiscreteDynamicsWorld& of_world_;
    btScalar time_step_s_;
    double time_s_;
    // The world goes before the bodies do.
    std::vector<std::unique_ptr<btCollisionObject>> stand_ins_;
    BreakableRegistry breakables_;
    std::unordered_map<const btCollisionObject*, btCollisionObject*> stand_in_of_;        // for look-up only
    std::unordered_map<const btCollisionObject*, const btCollisionObject*> original_of_;  // the same
    std::unordered_map<const Breakable*, Breakable*> original_breakable_of_;              // the same
    btDbvtBroadphase broadphase_;
    btCollisionDispatcher dispatcher_;
    PieceContacts piece_contacts_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    SolverDecorator decorator_;
    BirthOverlaps overlaps_;
    RecentStrikes recent_strikes_;
    StepSnapshot before_;
    MovedGround moved_ground_;  // stays where it is
    ImpulseWriteBack write_back_;
    std::vector<KnownContacts> known_contacts_;
    std::vector<StruckBreakable> struck_;
};

}  // namespace sherd
