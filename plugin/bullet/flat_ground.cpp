#include "bullet/flat_ground.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "bullet/convex_part.h"
#include "bullet/extra_contacts.h"
#include "bullet/standing_base.h"

namespace sherd {

namespace {

constexpr btScalar same_place_m = btScalar(1e-4);

/// What lies below a convex part: points x with normal.x < height, in the world, m.
struct HalfSpace {
    btVector3 normal = btVector3(0, 0, 1);
    btScalar height = 0;
};

HalfSpace placed(const btVector3& normal, btScalar height, const btTransform& frame) {
    const btVector3 turned = frame.getBasis() * normal;
    return {turned, height + turned.dot(frame.getOrigin())};
}

/// The face of a box that the middle of a part is least deep in, if all of the part is over it.
std::optional<HalfSpace> faceBelow(const ConvexPart& part, const btBoxShape& box, const btTransform& frame) {
    btVector3 low, high;
    part.shape->getAabb(frame.inverseTimes(part.transform), low, high);
    const btVector3 half = box.getHalfExtentsWithMargin(), middle = (low + high) / 2;
    const int axis = (middle.absolute() - half).maxAxis();
    for (int i = 0; i < 3; ++i)
        if (i != axis && (low[i] < -half[i] || high[i] > half[i])) return std::nullopt;
    btVector3 normal(0, 0, 0);
    normal[axis] = middle[axis] < 0 ? btScalar(-1) : btScalar(1);
    return placed(normal, half[axis], frame);
}

std::optional<HalfSpace> flatGroundBelow(const ConvexPart& part, const btCollisionObject& ground, int child) {
    const btTransform& frame = ground.getWorldTransform();
    const btCollisionShape& shape = *ground.getCollisionShape();
    if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
        const auto& plane = static_cast<const btStaticPlaneShape&>(shape);
        return placed(plane.getPlaneNormal(), plane.getPlaneConstant(), frame);
    }
    const ConvexPart below = partOf(ground, frame, child);
    if (!below.shape || below.shape->getShapeType() != BOX_SHAPE_PROXYTYPE) return std::nullopt;
    return faceBelow(part, static_cast<const btBoxShape&>(*below.shape), below.transform);
}

/// Of the vertices of a part those that are no further than `reach` above the ground, or else the lowest.
std::vector<Foot> feetWithin(btScalar reach, const ConvexPart& part, const HalfSpace& ground,
                             const btVector3& centre) {
    const btVector3 normal = ground.normal * part.transform.getBasis();  // in the frame of the part
    const btScalar margin = marginAround(*part.shape);
    const btScalar height = ground.height - ground.normal.dot(part.transform.getOrigin()) + margin;
    btVector3 x, y;
    btPlaneSpace1(ground.normal, x, y);
    const auto footAt = [&](const btVector3& vertex, btScalar above) {
        const btVector3 place = part.transform * vertex - margin * ground.normal, way = place - centre;
        return Foot{place, above, way.dot(x), way.dot(y)};
    };
    std::vector<Foot> feet;
    feet.reserve(16);
    btVector3 lowest(0, 0, 0);
    btScalar least = BT_LARGE_FLOAT;
    forEachVertex(*part.shape, [&](const btVector3& vertex) {
        const btScalar above = normal.dot(vertex) - height;
        if (above < reach) feet.push_back(footAt(vertex, above));
        if (!(above < least)) return;
        least = above;
        lowest = vertex;
    });
    if (feet.empty()) feet.push_back(footAt(lowest, least));
    return feet;
}

btScalar heightOfLowest(const std::vector<Foot>& feet) {
    btScalar least = BT_LARGE_FLOAT;
    for (const Foot& foot : feet) least = std::min(least, foot.above);
    return least;
}

std::vector<Foot> below(btScalar height, std::vector<Foot> feet) {
    feet.erase(
        std::remove_if(feet.begin(), feet.end(), [&](const Foot& foot) { return foot.above > height; }),
        feet.end());
    return feet;
}

std::vector<Foot> without(const std::vector<Foot>& known, std::vector<Foot> feet) {
    const auto is_known = [&](const Foot& foot) {
        return std::any_of(known.begin(), known.end(),
                           [&](const Foot& other) { return other.place == foot.place; });
    };
    feet.erase(std::remove_if(feet.begin(), feet.end(), is_known), feet.end());
    return feet;
}

void forgetImpulse(btManifoldPoint& point) {
    point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
}

/// Contacts of one convex part with the ground.
class Contacts {
  public:
    Contacts(btPersistentManifold& manifold, bool fragment_is_a, const HalfSpace& ground)
        : manifold_(manifold), is_a_(fragment_is_a), ground_(ground), model_(manifold.getContactPoint(0)) {
        forgetImpulse(model_);
        model_.m_userPersistentData = nullptr;  // the other point's
        model_.m_lifeTime = 0;
    }

    /// Makes the points of the manifold those of `base`.
    void moveTo(std::vector<Foot> base) {
        std::vector<int> left;
        for (int p = 0; p < manifold_.getNumContacts(); ++p) left.push_back(p);
        while (!left.empty() && !base.empty()) moveNearest(left, base);
        for (auto p = left.rbegin(); p != left.rend(); ++p) manifold_.removeContactPoint(*p);
        for (const Foot& foot : base) manifold_.addManifoldPoint(at(foot));
    }

    /// More points, for this step.
    void add(const std::vector<Foot>& more, btDiscreteDynamicsWorld& world) const {
        if (more.empty()) return;
        const btCollisionObject *a = manifold_.getBody0(), *b = manifold_.getBody1();
        btPersistentManifold* manifold = addExtraManifold(world, *a, *b);
        if (!manifold) return;
        for (const Foot& foot : more) {
            btManifoldPoint point = at(foot);
            if (foot.above > 0) point.m_combinedRestitution = 0;  // it may not touch in this step
            manifold->addManifoldPoint(point, true);
        }
    }

  private:
    /// The point and the foot that are closest to each other; elsewhere, its impulse is not known.
    void moveNearest(std::vector<int>& left, std::vector<Foot>& base) {
        std::size_t point = 0, foot = 0;
        btScalar least = BT_LARGE_FLOAT;
        for (std::size_t i = 0; i < left.size(); ++i)
            for (std::size_t j = 0; j < base.size(); ++j) {
                const btManifoldPoint& old = manifold_.getContactPoint(left[i]);
                const btVector3& was = is_a_ ? old.m_positionWorldOnA : old.m_positionWorldOnB;
                const btScalar distance = (was - base[j].place).length2();
                if (!(distance < least)) continue;
                least = distance;
                point = i;
                foot = j;
            }
        btManifoldPoint& old = manifold_.getContactPoint(left[point]);
        if (least > same_place_m * same_place_m) {
            forgetImpulse(old);
            old.m_lifeTime = 0;
        }
        move(old, base[foot]);
        left.erase(left.begin() + static_cast<long>(point));
        base.erase(base.begin() + static_cast<long>(foot));
    }

    btManifoldPoint at(const Foot& foot) const {
        btManifoldPoint point = model_;
        move(point, foot);
        return point;
    }

    void move(btManifoldPoint& point, const Foot& foot) const {
        const btVector3 on_ground = foot.place - ground_.normal * foot.above;
        point.m_positionWorldOnA = is_a_ ? foot.place : on_ground;
        point.m_positionWorldOnB = is_a_ ? on_ground : foot.place;
        point.m_localPointA = manifold_.getBody0()->getWorldTransform().invXform(point.m_positionWorldOnA);
        point.m_localPointB = manifold_.getBody1()->getWorldTransform().invXform(point.m_positionWorldOnB);
        point.m_normalWorldOnB = is_a_ ? ground_.normal : -ground_.normal;
        point.m_distance1 = foot.above;
    }

    btPersistentManifold& manifold_;
    const bool is_a_;
    const HalfSpace& ground_;
    btManifoldPoint model_;
};

bool isChangedByTheApp(const btCollisionObject& object) {
    constexpr int flags =
        btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK | btCollisionObject::CF_HAS_FRICTION_ANCHOR;
    return (object.getCollisionFlags() & flags) != 0;
}

/// Whether Bullet found that ground, too: the number of a part of a compound in a compound is not that of one
/// of its own parts.
bool agrees(const btPersistentManifold& manifold, bool fragment_is_a, const HalfSpace& ground) {
    constexpr btScalar parallel = btScalar(0.9);
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const btManifoldPoint& point = manifold.getContactPoint(p);
        const btVector3 up = fragment_is_a ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
        const btVector3& place = fragment_is_a ? point.m_positionWorldOnB : point.m_positionWorldOnA;
        const btScalar above = ground.normal.dot(place) - ground.height;
        if (up.dot(ground.normal) > parallel && btFabs(above) < manifold.getContactBreakingThreshold())
            return true;
    }
    return false;
}

}  // namespace

bool standOnFlatGround(btDiscreteDynamicsWorld& world, btPersistentManifold& manifold, bool fragment_is_a,
                       btScalar reach, btScalar even) {
    if (manifold.getNumContacts() == 0) return false;
    const btCollisionObject& fragment = fragment_is_a ? *manifold.getBody0() : *manifold.getBody1();
    const btCollisionObject& other = fragment_is_a ? *manifold.getBody1() : *manifold.getBody0();
    if (isChangedByTheApp(fragment) || isChangedByTheApp(other)) return false;
    const btManifoldPoint& first = manifold.getContactPoint(0);
    const btTransform& frame = fragment.getWorldTransform();
    const ConvexPart part = partOf(fragment, frame, fragment_is_a ? first.m_index0 : first.m_index1);
    if (!part.shape) return false;
    const auto ground = flatGroundBelow(part, other, fragment_is_a ? first.m_index1 : first.m_index0);
    if (!ground || !agrees(manifold, fragment_is_a, *ground)) return false;
    const std::vector<Foot> feet = feetWithin(reach, part, *ground, frame.getOrigin());
    const btScalar lowest = heightOfLowest(feet);
    const std::vector<Foot> low = below(lowest + std::max(-lowest / 2, even), feet);
    const std::vector<Foot> base = standingBase(low);
    Contacts contacts(manifold, fragment_is_a, *ground);
    contacts.moveTo(base);
    if (low.size() < feet.size()) contacts.add(without(base, standingBase(feet)), world);
    return true;
}

}  // namespace sherd
