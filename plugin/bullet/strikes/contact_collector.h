#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <sherd/push.h>

#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/ground/landing_points.h"
#include "bullet/island/island_state.h"
#include "bullet/shapes/flat_face.h"
#include "bullet/strikes/possible_strikes.h"
#include "core/loads/blow.h"

class btDiscreteDynamicsWorld;
struct btContactSolverInfo;

namespace sherd {

class BirthOverlaps;
class Piles;
class RecentStrikes;

/// A breakable body and what a solved step did to it.
struct StruckBreakable {
    Breakable* breakable = nullptr;
    BodyState before;                                ///< the solve, or the applied blow
    Blow blow;                                       ///< asset frame
    std::vector<const btCollisionObject*> partners;  ///< what touches it, by the numbers in the blow
    Vec3 position = Vec3::Zero();  ///< of the leading strike, else of the hardest contact, world frame, m
    Vec3 normal = Vec3::Zero();    ///< direction in which the body was pushed there, world frame
    std::vector<Vec3> pushes;      ///< of each contact, the direction in which it pushes, world frame
    const btCollisionObject* striker = nullptr;  ///< what pushed it there; nullptr: the app itself
    bool is_of_explosion = false;
    std::vector<Push> for_pieces;  ///< of a held body: what its loose pieces are still to be given

    /// Whether it is never left undecided for want of time: so is what an explosion does to whole and to held
    /// bodies, which nothing will strike again.
    bool isKept() const { return is_of_explosion && (!breakable->isFragment() || breakable->isHeld()); }
    /// The number of a partner; a new one gets the next.
    int numberOf(const btCollisionObject* partner);
};

/// The face with which either body of a contact touches the other one, at right angles to the normal; none
/// where it has no face there. That of a triangle has no sides.
struct FacesOfContact {
    std::optional<FlatFace> of_a, of_b;
};

/// Gathers every solved contact of breakable bodies: point, normal, normal and friction impulse, closing
/// speed. Speeds are those from before the solve, which lack the pull of this step's gravity: Bullet adds
/// that inside the solver. So a body at rest shows none, with one exception: now and then Bullet drops a
/// resting contact for a step, and the body comes back with what it fell meanwhile. Closing speeds up to two
/// steps of free fall of either body count as none. What the app pushes is no such case: it strikes.
class ContactCollector final : public btCollisionWorld::ContactResultCallback {
  public:
    /// `overlaps`: of bodies that were put into each other; nullptr: there are none. `recent`: what
    /// the steps before have left of strikes; nullptr: that is not told from new ones.
    ContactCollector(const BreakableRegistry& breakables, const StepSnapshot& before, double time_s,
                     const btContactSolverInfo& info, const BirthOverlaps* overlaps = nullptr,
                     RecentStrikes* recent = nullptr);

    /// One solved contact point, as Bullet's own contact queries report theirs; the return value has no
    /// meaning.
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* wrapper_a, int part_a,
                             int index_a, const btCollisionObjectWrapper* wrapper_b, int part_b,
                             int index_b) override;

    /// The manifold as it is to be fed, if it is not to be as it is: how bodies that are deep in each other
    /// met, one of them breakable.
    std::unique_ptr<btPersistentManifold> corrected(const btPersistentManifold& manifold) const;
    /// Of the points that are fed from here on.
    void setFaces(FacesOfContact faces) { faces_ = std::move(faces); }
    /// Announces the manifolds of the step, all of them before any is fed: bodies that they cannot break are
    /// left out.
    void expect(const btPersistentManifold& manifold);
    /// Looks for bodies that a strike on another one squeezes; these are not left out either.
    void lookForPiles(const std::vector<const btPersistentManifold*>& solved,
                      const std::vector<const btPersistentManifold*>& predictive);
    /// Whether a whole breakable body is one of the manifold's.
    bool isOfWhole(const btPersistentManifold& manifold) const;
    /// Whether a body of the manifold is not left out.
    bool listensTo(const btPersistentManifold& manifold) const;

    /// Where a body stood before the step's solve.
    const btTransform& stoodAt(const btCollisionObject& object) const;

    /// Whether the bodies of a manifold meet faster than bodies that rest on each other do.
    bool mayStrike(const btPersistentManifold& manifold) const;

    /// Whether two bodies would have met at a point that is still ahead of them by the end of the step, had
    /// nothing stopped them.
    bool wouldMeet(const btCollisionObject& a, const btCollisionObject& b,
                   const btManifoldPoint& point) const;

    /// How far the shape that stands for a body may be from its surface, m; 0: it is what it is.
    btScalar shapeTolerance(const btCollisionObject& object) const;

    /// A whole body as what lands with its surface. Without vertices for bodies of the app, pieces, boxes,
    /// and bodies whose shape the app has replaced or scaled.
    LandingBody landing(const btCollisionObject& object) const;

    /// The struck bodies, in the order in which they became breakable.
    std::vector<StruckBreakable> takeStruck();

  private:
    /// What is known of an object that touches another one.
    struct Party {
        const btCollisionObject* object = nullptr;
        const BodyState* before = nullptr;
        Breakable* breakable = nullptr;
        bool listens = false;
        btTransform asset_from_world = btTransform::getIdentity();  // where it listens
    };
    struct Side {
        const Party* party;
        btVector3 point;    // world frame
        btVector3 push;     // unit, the direction in which the contact pushes this side
        btVector3 impulse;  // on this side
        int child;
        const FlatFace* face;  // that touches; nullptr: none
    };
    /// Below it, what Bullet gives is taken.
    static constexpr btScalar slowest_landing_m_s = btScalar(0.1);

    void lookUp(const btCollisionObject& object, Party& party) const;
    StruckBreakable& entryOf(Breakable& breakable, const btTransform& asset_from_world);
    void correctTouch(Side& own, Side& other, btManifoldPoint& point) const;
    void addSide(Side own, Side other, btManifoldPoint point);
    bool isExempt(const Side& own, const Side& other) const;
    bool isLeftOver(const Side& own, const Side& other, double closing_m_s, double slowest_m_s) const;
    bool rubInEachOther(const Side& own, const Side& other, double closing_m_s) const;
    btVector3 placeOfTouch(const Side& own, const Side& other, btScalar radius, const btVector3& velocity,
                           double touched_s) const;
    std::shared_ptr<const TouchingSurface> surfaceAt(const Side& own, const btVector3& push) const;
    ContactImpulse contactOn(const Side& own, const Side& other, const btManifoldPoint& point) const;
    bool listens(const Breakable& breakable) const;

    const BreakableRegistry& breakables_;
    const StepSnapshot& before_;
    const BirthOverlaps* overlaps_;
    double time_s_;
    double time_step_s_;
    bool two_friction_directions_;
    PossibleStrikes possible_;
    std::shared_ptr<const Piles> piles_;
    RecentStrikes* recent_;
    FacesOfContact faces_;
    Party party_a_, party_b_;  // of the last point: those of a manifold follow each other
    std::vector<StruckBreakable> struck_;
    std::unordered_map<const Breakable*, std::size_t> place_in_struck_;  // for look-up only
};

/// Feeds a collector with the contacts that the step just solved. Left out: pairs asleep, pairs without
/// response and points that the solver leaves out, which all keep impulses of earlier steps.
void feedSolvedContacts(btDiscreteDynamicsWorld& world, ContactCollector& collector);

}  // namespace sherd
