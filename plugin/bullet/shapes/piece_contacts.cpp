#include "bullet/shapes/piece_contacts.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "bullet/shapes/piece_hull.h"

namespace sherd {

namespace {

// Radii, in units. That of the smaller body, of which Bullet's tolerances are then 1e-5; and what that of the
// larger is at most, of which single precision rounds by as much.
constexpr btScalar small = 10, largest = 1000;

constexpr btScalar large_m = btScalar(0.1);  // radius from which on Bullet misses no contact

// Faster pairs are Bullet's: what it misses of them it finds a step or two later, and with all of it found a
// chain of breaks depends twice as much on the rate of the steps, since debris runs further ahead.
constexpr btScalar slow_m_s = 1;

btScalar radiusOf(const btCollisionObjectWrapper& body) {
    btVector3 centre;
    btScalar radius;
    body.getCollisionShape()->getBoundingSphere(centre, radius);
    return radius;
}

/// In metres where one of the two is too large for it.
btScalar unitsPerMetre(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b) {
    const auto [smaller, larger] = std::minmax({radiusOf(a), radiusOf(b)});
    if (!(smaller > 0)) return 1;
    return std::max(std::min(small / smaller, largest / larger), btScalar(1));
}

/// Back into metres.
class InMetres final : public btDiscreteCollisionDetectorInterface::Result {
  public:
    InMetres(btManifoldResult& result, btScalar units_per_m, const btVector3& origin)
        : result_(result), units_per_m_(units_per_m), origin_(origin) {}
    void setShapeIdentifiersA(int part, int index) override { result_.setShapeIdentifiersA(part, index); }
    void setShapeIdentifiersB(int part, int index) override { result_.setShapeIdentifiersB(part, index); }
    void addContactPoint(const btVector3& normal_on_b, const btVector3& on_b, btScalar distance) override {
        result_.addContactPoint(normal_on_b, on_b / units_per_m_ + origin_, distance / units_per_m_);
    }

  private:
    btManifoldResult& result_;
    const btScalar units_per_m_;
    const btVector3& origin_;
};

bool isPiece(const btCollisionObjectWrapper& body) {
    return PieceHull::is(*body.getCollisionShape());
}

/// Whether one of two convex shapes is a piece, and the smaller one is small.
bool isFoundHere(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b) {
    return (isPiece(a) || isPiece(b)) && std::min(radiusOf(a), radiusOf(b)) < large_m;
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

/// As btConvexConvexAlgorithm, in other units.
class PieceAlgorithm final : public btActivatingCollisionAlgorithm {
  public:
    PieceAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                   const btCollisionObjectWrapper* b, btCollisionAlgorithmCreateFunc& usual)
        : btActivatingCollisionAlgorithm(info, a, b),
          manifold_(info.m_manifold),
          usual_function_(usual),
          units_per_m_(unitsPerMetre(*a, *b)) {}
    ~PieceAlgorithm() override {
        dropUsual();
        if (owns_manifold_) m_dispatcher->releaseManifold(manifold_);
    }
    PieceAlgorithm(const PieceAlgorithm&) = delete;
    PieceAlgorithm& operator=(const PieceAlgorithm&) = delete;

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& info, btManifoldResult* result) override {
        const btCollisionObject *of_a = a->getCollisionObject(), *of_b = b->getCollisionObject();
        if (!manifold_) {
            manifold_ = m_dispatcher->getNewManifold(of_a, of_b);
            owns_manifold_ = true;
        }
        result->setPersistentManifold(manifold_);
        if (meetingSpeed(*of_a, *of_b) > slow_m_s) {
            usual(*a, *b).processCollision(a, b, info, result);
        } else {
            dropUsual();
            addContact(*a, *b, info, *result);
        }
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

    /// With the contacts of one that does not use the manifold that it is given.
    void dropUsual() {
        if (!usual_) return;
        usual_->~btCollisionAlgorithm();
        m_dispatcher->freeCollisionAlgorithm(usual_);
        usual_ = nullptr;
    }

    static const btConvexShape& shapeOf(const btCollisionObjectWrapper& body) {
        return static_cast<const btConvexShape&>(*body.getCollisionShape());
    }

    /// The one where the bodies are nearest, if that is near enough: a step finds one contact.
    void addContact(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b,
                    const btDispatcherInfo& info, btManifoldResult& result) const {
        const btConvexShape &of_a = shapeOf(a), &of_b = shapeOf(b);
        const btUniformScalingShape large_a(const_cast<btConvexShape*>(&of_a), units_per_m_),
            large_b(const_cast<btConvexShape*>(&of_b), units_per_m_);
        const btVector3 origin = a.getWorldTransform().getOrigin();
        btGjkPairDetector::ClosestPointInput input;
        input.m_transformA = btTransform(a.getWorldTransform().getBasis());
        input.m_transformB = btTransform(b.getWorldTransform().getBasis(),
                                         units_per_m_ * (b.getWorldTransform().getOrigin() - origin));
        const btScalar furthest =
            units_per_m_ * (of_a.getMargin() + of_b.getMargin() + manifold_->getContactBreakingThreshold() +
                            result.m_closestPointDistanceThreshold);
        input.m_maximumDistanceSquared = furthest * furthest;
        btVoronoiSimplexSolver simplex;
        btGjkEpaPenetrationDepthSolver penetration_depth;
        btGjkPairDetector detector(&large_a, &large_b, &simplex, &penetration_depth);
        InMetres in_metres(result, units_per_m_, origin);
        detector.getClosestPoints(input, in_metres, info.m_debugDraw);
    }

    btPersistentManifold* manifold_;
    btCollisionAlgorithmCreateFunc& usual_function_;
    btCollisionAlgorithm* usual_ = nullptr;
    const btScalar units_per_m_;
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
    Entry(btCollisionAlgorithmCreateFunc& usual, int a, int b) : usual(usual), a(a), b(b) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* of_a,
                                                   const btCollisionObjectWrapper* of_b) override {
        if (!isFoundHere(*of_a, *of_b)) return usual.CreateCollisionAlgorithm(info, of_a, of_b);
        void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(PieceAlgorithm));
        return new (memory) PieceAlgorithm(info, of_a, of_b, usual);
    }

    btCollisionAlgorithmCreateFunc& usual;
    const int a, b;  // types of shapes
};

class PieceContacts::Table {
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
                dispatcher_.registerCollisionCreateFunc(entry->a, entry->b, &entry->usual);
    }
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;

    /// The one that the dispatcher has, or a new one.
    static std::shared_ptr<Table> of(btCollisionDispatcher& dispatcher) {
        static std::mutex mutex;
        // For look-up only; never destroyed, as worlds may end last.
        static auto& tables = *new std::map<const btCollisionDispatcher*, std::weak_ptr<Table>>;
        const std::lock_guard lock(mutex);
        for (auto it = tables.begin(); it != tables.end();)
            it = it->second.expired() ? tables.erase(it) : std::next(it);
        std::weak_ptr<Table>& known = tables[&dispatcher];
        std::shared_ptr<Table> table = known.lock();
        if (!table) known = table = std::make_shared<Table>(dispatcher);
        return table;
    }

  private:
    void add(int a, int b) {
        entries_.push_back(std::make_unique<Entry>(*DispatcherInternals::entry(dispatcher_, a, b), a, b));
        dispatcher_.registerCollisionCreateFunc(a, b, entries_.back().get());
    }

    btCollisionDispatcher& dispatcher_;
    std::vector<std::unique_ptr<Entry>> entries_;
};

PieceContacts::PieceContacts(btDispatcher& dispatcher) {
    if (auto* known = dynamic_cast<btCollisionDispatcher*>(&dispatcher)) table_ = Table::of(*known);
}

}  // namespace sherd
