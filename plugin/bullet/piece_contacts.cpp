#include "bullet/piece_contacts.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "bullet/facing_sides.h"
#include "bullet/piece_hull.h"

namespace sherd {

namespace {

// Radii, in units. That of the smaller body, of which Bullet's tolerances are then 1e-5; and what that of the
// larger is at most: its rounding in single precision stays below these tolerances.
constexpr btScalar small = 10, largest = 1000;

// Faster pairs are Bullet's: what it misses of them it finds a step or two later, and with all of it found a
// chain of breaks depends twice as much on the rate of the steps, since debris runs further ahead.
constexpr btScalar slow_m_s = 1;

btScalar radiusOf(const btConvexShape& shape) {
    btVector3 centre;
    btScalar radius;
    shape.getBoundingSphere(centre, radius);
    return radius;
}

/// In metres where one of the two is too large for it.
btScalar unitsPerMetre(btScalar radius_a, btScalar radius_b) {
    const btScalar smaller = std::min(radius_a, radius_b), larger = std::max(radius_a, radius_b);
    if (!(smaller > 0)) return 1;
    return std::max(std::min(small / smaller, largest / larger), btScalar(1));
}

/// The last contact that is found.
struct Nearest final : btDiscreteCollisionDetectorInterface::Result {
    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3& normal_on_b, const btVector3& point, btScalar depth) override {
        normal = normal_on_b;
        on_b = point;
        distance = depth;
    }
    btVector3 normal{0, 0, 0}, on_b{0, 0, 0};  // the normal on B
    btScalar distance = BT_LARGE_FLOAT;
};

const PieceHull* pieceHull(const btCollisionObjectWrapper& body) {
    return dynamic_cast<const PieceHull*>(body.getCollisionShape());
}

/// How fast points of the two may meet, m/s. What is no rigid body counts as one that stands.
btScalar meetingSpeed(const btCollisionObject& a, const btCollisionObject& b) {
    btVector3 meeting(0, 0, 0);
    btScalar turning = 0;
    const auto add = [&](const btCollisionObject& object, btScalar sign) {
        const btRigidBody* body = btRigidBody::upcast(&object);
        if (!body) return;
        meeting += sign * body->getLinearVelocity();
        turning += body->getAngularVelocity().length() * body->getCollisionShape()->getAngularMotionDisc();
    };
    add(a, 1);
    add(b, -1);
    return meeting.length() + turning;
}

/// As btConvexConvexAlgorithm, in other units and with all contacts of two sides at once.
class PieceAlgorithm final : public btActivatingCollisionAlgorithm {
  public:
    PieceAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                   const btCollisionObjectWrapper* b, btCollisionAlgorithmCreateFunc& usual)
        : btActivatingCollisionAlgorithm(info, a, b), manifold_(info.m_manifold), usual_function_(usual) {
        const btCollisionObject *of_a = a->getCollisionObject(), *of_b = b->getCollisionObject();
        if (manifold_ || !m_dispatcher->needsCollision(of_a, of_b)) return;
        manifold_ = m_dispatcher->getNewManifold(of_a, of_b);
        owns_manifold_ = true;
    }
    ~PieceAlgorithm() override {
        if (usual_) {
            usual_->~btCollisionAlgorithm();
            m_dispatcher->freeCollisionAlgorithm(usual_);
        }
        if (owns_manifold_) m_dispatcher->releaseManifold(manifold_);
    }
    PieceAlgorithm(const PieceAlgorithm&) = delete;
    PieceAlgorithm& operator=(const PieceAlgorithm&) = delete;

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& info, btManifoldResult* result) override {
        if (!manifold_) return;
        result->setPersistentManifold(manifold_);
        if (meetingSpeed(*a->getCollisionObject(), *b->getCollisionObject()) > slow_m_s)
            usual(*a, *b).processCollision(a, b, info, result);
        else
            addContacts(*a, *b, info, *result);
        if (owns_manifold_) result->refreshContactPoints();
    }
    btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                   btManifoldResult*) override {
        return 1;  // Bullet's worlds ask btContinuousConvexCollision instead
    }
    void getAllContactManifolds(btManifoldArray& manifolds) override {
        if (owns_manifold_) manifolds.push_back(manifold_);
        if (usual_) usual_->getAllContactManifolds(manifolds);  // of one that does not use what it is given
    }

  private:
    /// What the dispatcher has for such shapes otherwise, on the same manifold.
    btCollisionAlgorithm& usual(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b) {
        if (!usual_) {
            btCollisionAlgorithmConstructionInfo info(m_dispatcher, 0);
            info.m_manifold = manifold_;
            usual_ = usual_function_.CreateCollisionAlgorithm(info, &a, &b);
        }
        return *usual_;
    }

    static const btConvexShape& shapeOf(const btCollisionObjectWrapper& body) {
        return static_cast<const btConvexShape&>(*body.getCollisionShape());
    }

    /// Where the bodies are nearest, in metres; far away if that is further than `furthest`, m.
    Nearest nearestOf(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b, btScalar furthest,
                      const btDispatcherInfo& info) const {
        const btConvexShape &of_a = shapeOf(a), &of_b = shapeOf(b);
        const btScalar units_per_m = unitsPerMetre(radiusOf(of_a), radiusOf(of_b));
        const btUniformScalingShape large_a(const_cast<btConvexShape*>(&of_a), units_per_m),
            large_b(const_cast<btConvexShape*>(&of_b), units_per_m);
        const btVector3 origin = a.getWorldTransform().getOrigin();
        btGjkPairDetector::ClosestPointInput input;
        input.m_transformA = btTransform(a.getWorldTransform().getBasis());
        input.m_transformB = btTransform(b.getWorldTransform().getBasis(),
                                         units_per_m * (b.getWorldTransform().getOrigin() - origin));
        const btScalar between_cores = units_per_m * (of_a.getMargin() + of_b.getMargin() + furthest);
        input.m_maximumDistanceSquared = between_cores * between_cores;
        btVoronoiSimplexSolver simplex;
        btGjkEpaPenetrationDepthSolver penetration_depth;
        btGjkPairDetector detector(&large_a, &large_b, &simplex, &penetration_depth);
        Nearest nearest;
        detector.getClosestPoints(input, nearest, info.m_debugDraw);
        if (nearest.distance == BT_LARGE_FLOAT) return nearest;
        nearest.on_b = nearest.on_b / units_per_m + origin;
        nearest.distance /= units_per_m;
        return nearest;
    }

    /// Where the bodies are nearest is all that GJK finds in a step. It stands for all of a side that
    /// touches, so it is left out if corners of that are as near.
    void addContacts(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b,
                     const btDispatcherInfo& info, btManifoldResult& result) const {
        constexpr btScalar as_near = btScalar(0.1);  // of how far contacts may be off
        const btScalar furthest =
            manifold_->getContactBreakingThreshold() + result.m_closestPointDistanceThreshold;
        const Nearest nearest = nearestOf(a, b, furthest, info);
        if (nearest.distance > furthest) return;
        const PieceHull *piece_a = pieceHull(a), *piece_b = pieceHull(b);
        btScalar of_sides = BT_LARGE_FLOAT;
        if (piece_a && piece_b)
            of_sides = addContactsOfSides({piece_a->sides, a.getWorldTransform(), piece_a->getMargin()},
                                          {piece_b->sides, b.getWorldTransform(), piece_b->getMargin()},
                                          nearest.normal, nearest.distance, furthest, result);
        if (of_sides > nearest.distance + as_near * furthest)
            result.addContactPoint(nearest.normal, nearest.on_b, nearest.distance);
    }

    btPersistentManifold* manifold_;
    btCollisionAlgorithmCreateFunc& usual_function_;
    btCollisionAlgorithm* usual_ = nullptr;
    bool owns_manifold_ = false;
};

// A dispatcher's pool has room for the largest of Bullet's own.
static_assert(sizeof(PieceAlgorithm) <= sizeof(btConvexConvexAlgorithm));

/// A protected member without an accessor: a derived class may name it, and a pointer to member works on any
/// dispatcher.
class DispatcherInternals : private btCollisionDispatcher {
  public:
    DispatcherInternals() = delete;
    static btCollisionAlgorithmCreateFunc* entry(btCollisionDispatcher& dispatcher, int a, int b) {
        return (dispatcher.*(&DispatcherInternals::m_doubleDispatchContactPoints))[a][b];
    }
};

}  // namespace

class PieceContacts::Entry final : public btCollisionAlgorithmCreateFunc {
  public:
    Entry(Table& table, btCollisionAlgorithmCreateFunc* usual, int a, int b)
        : table(table), usual(usual), a(a), b(b) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* of_a,
                                                   const btCollisionObjectWrapper* of_b) override {
        if (!pieceHull(*of_a) && !pieceHull(*of_b)) return usual->CreateCollisionAlgorithm(info, of_a, of_b);
        void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(PieceAlgorithm));
        return new (memory) PieceAlgorithm(info, of_a, of_b, *usual);
    }

    Table& table;
    btCollisionAlgorithmCreateFunc* usual;
    const int a, b;  // types of shapes
};

class PieceContacts::Table : public std::enable_shared_from_this<Table> {
  public:
    explicit Table(btCollisionDispatcher& dispatcher) : dispatcher_(dispatcher) {
        constexpr int hull = CONVEX_HULL_SHAPE_PROXYTYPE;
        for (int other = 0; btBroadphaseProxy::isConvex(other); ++other) {
            add(hull, other);
            if (other != hull) add(other, hull);
        }
    }
    ~Table() {
        for (const auto& entry : entries_)
            if (DispatcherInternals::entry(dispatcher_, entry->a, entry->b) == entry.get())
                dispatcher_.registerCollisionCreateFunc(entry->a, entry->b, entry->usual);
    }
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;

    static std::shared_ptr<Table> of(btCollisionDispatcher& dispatcher) {
        constexpr int hull = CONVEX_HULL_SHAPE_PROXYTYPE;
        if (auto* entry = dynamic_cast<Entry*>(DispatcherInternals::entry(dispatcher, hull, hull)))
            return entry->table.shared_from_this();
        return std::make_shared<Table>(dispatcher);
    }

  private:
    void add(int a, int b) {
        entries_.push_back(
            std::make_unique<Entry>(*this, DispatcherInternals::entry(dispatcher_, a, b), a, b));
        dispatcher_.registerCollisionCreateFunc(a, b, entries_.back().get());
    }

    btCollisionDispatcher& dispatcher_;
    std::vector<std::unique_ptr<Entry>> entries_;
};

PieceContacts::PieceContacts(btDispatcher& dispatcher) {
    if (auto* known = dynamic_cast<btCollisionDispatcher*>(&dispatcher)) table_ = Table::of(*known);
}

}  // namespace sherd
