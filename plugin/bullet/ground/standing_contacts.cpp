#include "bullet/ground/standing_contacts.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>

#include "bullet/ground/even_ground.h"
#include "bullet/shapes/convex_part.h"
#include "bullet/world/extra_contacts.h"

namespace sherd {

namespace {

constexpr btScalar same_place_m = btScalar(1e-4);

/// Of a facet, in the frame of a part.
struct Plane {
    btVector3 normal;
    btScalar height;
};

std::vector<Plane> planesSeenFrom(const ConvexPart& part, const EvenGround& ground, btScalar margin) {
    std::vector<Plane> planes;
    planes.reserve(ground.facets.size());
    for (const Facet& facet : ground.facets)
        planes.push_back(
            {facet.normal * part.transform.getBasis(), margin - facet.above(part.transform.getOrigin())});
    return planes;
}

/// Above all planes: most vertices are too high to be looked at in the world.
btScalar leastAbove(const std::vector<Plane>& planes, const btVector3& vertex) {
    btScalar least = BT_LARGE_FLOAT;
    for (const Plane& plane : planes) least = std::min(least, plane.normal.dot(vertex) - plane.height);
    return least;
}

/// The vertices of a part that are no further than `reach` above the ground, or else the lowest; none if one
/// of them is beside the ground: the part may hang over an edge, which no vertex tells of.
std::vector<Foot> feetWithin(btScalar reach, const ConvexPart& part, const EvenGround& ground,
                             const btVector3& centre) {
    const btScalar margin = marginAround(*part.shape);
    btVector3 x, y;
    btPlaneSpace1(ground.up, x, y);
    std::vector<Foot> feet;
    feet.reserve(static_cast<std::size_t>(part.shape->getNumVertices()));
    bool is_beside = false;
    const auto add = [&](const btVector3& vertex, btScalar highest) {
        const btVector3 at = part.transform * vertex;
        const Facet* facet = ground.under(at - margin * ground.up);
        if (!facet) {
            is_beside = true;
            return;
        }
        const btVector3 place = at - margin * facet->normal, way = place - centre;
        const btScalar above = facet->above(place);
        if (above < highest) feet.push_back({place, above, way.dot(x), way.dot(y), facet->normal});
    };
    const std::vector<Plane> planes = planesSeenFrom(part, ground, margin);
    btVector3 lowest(0, 0, 0);
    btScalar least = BT_LARGE_FLOAT;
    forEachVertex(*part.shape, [&](const btVector3& vertex) {
        const btScalar above = leastAbove(planes, vertex);
        if (above < reach) add(vertex, reach);
        if (!(above < least)) return;
        least = above;
        lowest = vertex;
    });
    if (feet.empty()) add(lowest, BT_LARGE_FLOAT);
    if (is_beside) feet.clear();
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

/// Those that come next to the ground: for one of the upper side of a body, straight above another one, that
/// would have to roll over.
std::vector<Foot> lowerSide(const std::vector<Foot>& feet) {
    constexpr btScalar straight = 8;                 // tangent
    std::vector<btScalar> numbers(3 * feet.size());  // side by side, for a loop over pairs without branches
    btScalar *x = numbers.data(), *y = x + feet.size(), *above = y + feet.size();
    for (std::size_t i = 0; i < feet.size(); ++i) {
        x[i] = feet[i].x;
        y[i] = feet[i].y;
        above[i] = feet[i].above;
    }
    std::vector<Foot> lower;
    lower.reserve(feet.size());
    for (const Foot& foot : feet) {
        int is_upper = 0;
        for (std::size_t i = 0; i < feet.size(); ++i) {
            const btScalar to_x = foot.x - x[i], to_y = foot.y - y[i], higher = foot.above - above[i];
            is_upper |= (higher > 0) & (higher * higher > straight * straight * (to_x * to_x + to_y * to_y));
        }
        if (!is_upper) lower.push_back(foot);
    }
    return lower;
}

void forgetImpulse(btManifoldPoint& point) {
    point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
}

/// Contacts of one convex part with the ground.
class Contacts {
  public:
    Contacts(btPersistentManifold& manifold, bool fragment_is_a)
        : manifold_(manifold), is_a_(fragment_is_a), model_(manifold.getContactPoint(0)) {
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

    /// Removes the points that do not push along `up`.
    void keepThoseAlong(const btVector3& up) {
        constexpr btScalar along = btScalar(0.96);  // cosine
        for (int p = manifold_.getNumContacts() - 1; p >= 0; --p) {
            const btVector3& normal = manifold_.getContactPoint(p).m_normalWorldOnB;
            if ((is_a_ ? normal : -normal).dot(up) < along) manifold_.removeContactPoint(p);
        }
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
        const btVector3 on_ground = foot.place - foot.normal * foot.above;
        point.m_positionWorldOnA = is_a_ ? foot.place : on_ground;
        point.m_positionWorldOnB = is_a_ ? on_ground : foot.place;
        point.m_localPointA = manifold_.getBody0()->getWorldTransform().invXform(point.m_positionWorldOnA);
        point.m_localPointB = manifold_.getBody1()->getWorldTransform().invXform(point.m_positionWorldOnB);
        point.m_normalWorldOnB = is_a_ ? foot.normal : -foot.normal;
        point.m_distance1 = foot.above;
    }

    btPersistentManifold& manifold_;
    const bool is_a_;
    btManifoldPoint model_;
};

bool isChangedByTheApp(const btCollisionObject& object) {
    constexpr int flags =
        btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK | btCollisionObject::CF_HAS_FRICTION_ANCHOR;
    return (object.getCollisionFlags() & flags) != 0;
}

}  // namespace

bool standOnEvenGround(btDiscreteDynamicsWorld& world, btPersistentManifold& manifold, bool fragment_is_a,
                       const btVector3& inside, btScalar reach, btScalar even) {
    if (manifold.getNumContacts() == 0) return false;
    const btCollisionObject& fragment = fragment_is_a ? *manifold.getBody0() : *manifold.getBody1();
    const btCollisionObject& other = fragment_is_a ? *manifold.getBody1() : *manifold.getBody0();
    if (isChangedByTheApp(fragment) || isChangedByTheApp(other)) return false;
    const btManifoldPoint& first = manifold.getContactPoint(0);
    const btTransform& frame = fragment.getWorldTransform();
    const ConvexPart part = partOf(fragment, frame, fragment_is_a ? first.m_index0 : first.m_index1);
    if (!part.shape) return false;
    const EvenGround ground = evenGround({part.shape, part.transform}, manifold, fragment_is_a,
                                         other.getWorldTransform(), inside, false);
    if (ground.facets.empty()) return false;
    const std::vector<Foot> feet = feetWithin(reach, part, ground, frame.getOrigin());
    if (feet.empty()) return false;
    const btScalar lowest = heightOfLowest(feet);
    const std::vector<Foot> low = below(lowest + std::max(-lowest / 2, even), feet);
    const std::vector<Foot> base = standingBase(low);
    Contacts contacts(manifold, fragment_is_a);
    if (ground.has_ridges) {  // which Bullet knows of
        contacts.keepThoseAlong(ground.up);
        contacts.add(base, world);
        return true;
    }
    contacts.moveTo(base);
    if (low.size() < feet.size()) contacts.add(without(base, standingBase(lowerSide(feet))), world);
    return true;
}

std::vector<Foot> feetIn(const btCollisionObject& surface, const btRigidBody& fragment,
                         const btVector3& inside) {
    const btTransform& frame = fragment.getWorldTransform();
    const btCollisionShape& shape = *fragment.getCollisionShape();
    const int count = shape.isCompound() ? static_cast<const btCompoundShape&>(shape).getNumChildShapes() : 1;
    std::vector<Foot> feet;
    for (int child = 0; child < count; ++child) {
        const ConvexPart part = partOf(fragment, frame, child);
        if (!part.shape) continue;
        const EvenGround ground = evenSurface({part.shape, part.transform}, surface, inside);
        if (ground.facets.empty()) continue;
        const std::vector<Foot> own = feetWithin(0, part, ground, frame.getOrigin());
        feet.insert(feet.end(), own.begin(), own.end());
    }
    const btScalar lowest = heightOfLowest(feet);
    return lowest < 0 ? standingBase(below(lowest / 2, feet)) : std::vector<Foot>();
}

}  // namespace sherd
