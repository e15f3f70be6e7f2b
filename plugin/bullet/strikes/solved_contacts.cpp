// How the manifolds of a solved step are fed to a collector.

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bullet/ground/ground_surface.h"
#include "bullet/ground/landing_points.h"
#include "bullet/island/contact_motion.h"
#include "bullet/shapes/box_faces.h"
#include "bullet/shapes/convex_part.h"
#include "bullet/shapes/flat_face.h"
#include "bullet/shapes/missed_vertices.h"
#include "bullet/strikes/contact_collector.h"
#include "bullet/strikes/met_on_the_way.h"
#include "bullet/world/extra_contacts.h"

namespace sherd {

namespace {

/// Predictive contacts (continuous collision) put the centre of the swept sphere where other contacts have
/// the point.
void moveToSurface(btManifoldPoint& point, const btCollisionObject& swept) {
    const btVector3 to_surface = -point.m_normalWorldOnB * swept.getCcdSweptSphereRadius();
    point.m_positionWorldOnA += to_surface;
    point.m_positionWorldOnB += to_surface;
}

/// A ball touches where its normal leaves it. Bullet may give a point far from there where its centre comes
/// to lie on the other one's surface.
void moveToBall(btManifoldPoint& point, const btCollisionObject& a, const btCollisionObject& b,
                const ContactCollector& collector) {
    const btVector3 out_of_b = point.m_normalWorldOnB;
    const auto radiusOf = [](const btCollisionObject& object) {
        return static_cast<const btSphereShape*>(object.getCollisionShape())->getRadius();
    };
    if (a.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE) {
        point.m_positionWorldOnA = collector.stoodAt(a).getOrigin() - radiusOf(a) * out_of_b;
        point.m_positionWorldOnB = point.m_positionWorldOnA - point.getDistance() * out_of_b;
    } else if (b.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE) {
        point.m_positionWorldOnB = collector.stoodAt(b).getOrigin() + radiusOf(b) * out_of_b;
        point.m_positionWorldOnA = point.m_positionWorldOnB + point.getDistance() * out_of_b;
    }
}

/// How far the shapes of a manifold's bodies may be from their surfaces, m.
btScalar toleranceOf(const btPersistentManifold& manifold, const ContactCollector& collector) {
    return std::max(collector.shapeTolerance(*manifold.getBody0()),
                    collector.shapeTolerance(*manifold.getBody1()));
}

/// The vertices that a manifold lacks: what lands on several of them touches with all at about the same time.
std::vector<btManifoldPoint> landedVertices(const btPersistentManifold& manifold, const btTransform& stood_a,
                                            const btTransform& stood_b, btScalar tolerance, bool on_hulls) {
    if (tolerance == 0)  // as near as Bullet's own points
        return missedVertices(manifold, stood_a, stood_b,
                              {manifold.getContactBreakingThreshold(), false, on_hulls});
    btScalar deepest = BT_LARGE_FLOAT;  // above zero for what is about to land
    for (int i = 0; i < manifold.getNumContacts(); ++i)
        deepest = std::min(deepest, manifold.getContactPoint(i).getDistance());
    return missedVertices(manifold, stood_a, stood_b,
                          {std::max(deepest, btScalar(0)) + tolerance, true, on_hulls});
}

/// What is no deeper than the tolerance of a shape above the deepest is met with that.
void meetTogether(std::vector<btManifoldPoint>& points, btScalar tolerance) {
    btScalar deepest = BT_LARGE_FLOAT;
    for (const btManifoldPoint& point : points) deepest = std::min(deepest, point.getDistance());
    for (btManifoldPoint& point : points)
        if (point.getDistance() < deepest + tolerance) point.setDistance(deepest);
}

constexpr btScalar faint = btScalar(1e-3);  // of the whole impulse: a point counts as pressed

btScalar impulseOf(const std::vector<btManifoldPoint>& points) {
    btScalar sum = 0;
    for (const btManifoldPoint& point : points) sum += std::max(btScalar(0), point.m_appliedImpulse);
    return sum;
}

/// What lands would have met in this step what is still a little off, too: Bullet loads only what it needs to
/// stop the body.
void pressLanding(std::vector<btManifoldPoint>& points, const btCollisionObject& a,
                  const btCollisionObject& b, const ContactCollector& collector) {
    const btScalar sum = impulseOf(points);
    for (btManifoldPoint& point : points)
        if (point.getDistance() > 0 && point.m_appliedImpulse < faint * sum &&
            collector.wouldMeet(a, b, point))
            point.m_appliedImpulse = faint * sum;
}

/// What bodies that rest on each other touch with, pressed or not: which points of a flat contact Bullet
/// presses depends on the step, and a face that leans against another is tilted by hardly anything.
void pressEvenly(std::vector<btManifoldPoint>& points) {
    const btScalar sum = impulseOf(points);
    for (btManifoldPoint& point : points)
        if (point.getDistance() <= btScalar(largestRestingGap()))
            point.m_appliedImpulse = std::max(point.m_appliedImpulse, faint * sum);
}

/// Gives the impulses of a point to others, in equal parts.
void share(const btManifoldPoint& point, std::vector<btManifoldPoint>& others) {
    const btScalar part = 1 / static_cast<btScalar>(others.size());
    for (btManifoldPoint& other : others) {
        other.m_appliedImpulse += part * point.m_appliedImpulse;
        other.m_appliedImpulseLateral1 += part * point.m_appliedImpulseLateral1;
        other.m_appliedImpulseLateral2 += part * point.m_appliedImpulseLateral2;
    }
}

/// Whether a point lies on a plane or a box.
bool isOnFace(const btManifoldPoint& point, const btCollisionObject& a, const btCollisionObject& b) {
    const auto isFlat = [](const btCollisionObject& object, int child) {
        const btCollisionShape* shape = childOf(object, object.getWorldTransform(), child).shape;
        return shape && (shape->getShapeType() == BOX_SHAPE_PROXYTYPE ||
                         shape->getShapeType() == STATIC_PLANE_PROXYTYPE);
    };
    return isFlat(a, point.m_index0) || isFlat(b, point.m_index1);
}

/// The face of an object that touches at a place: of its part there, or a triangle.
std::optional<FlatFace> faceThatTouches(const btCollisionObject& object, const btTransform& stood, int child,
                                        const btVector3& outward, const btVector3& place) {
    constexpr btScalar along = btScalar(0.9999);
    const PlacedShape part = childOf(object, stood, child);
    if (!part.shape) return std::nullopt;
    if (!part.shape->isConcave() || part.shape->getShapeType() == STATIC_PLANE_PROXYTYPE) {
        auto face = faceTowards(part, outward);
        if (face && !(face->normal.dot(outward) > along)) face.reset();
        return face;
    }
    const btVector3 near(gContactBreakingThreshold, gContactBreakingThreshold, gContactBreakingThreshold);
    bool is_triangle = false;
    forEachTriangle(object, place - near, place + near, [&](const std::array<btVector3, 3>& corners) {
        const btVector3 area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        is_triangle = is_triangle || btFabs(area.dot(outward)) > along * area.length();
    });
    if (!is_triangle) return std::nullopt;
    return FlatFace{outward, outward.dot(place)};
}

/// What lands on flat ground. A body of several parts has a manifold for each of them, all of which it is fed
/// with at once.
class Landings {
  public:
    Landings(const std::vector<btPersistentManifold*>& solved, const ContactCollector& collector)
        : solved_(solved), collector_(collector) {}

    /// Whether what the manifold says has been fed with another one.
    bool know(const btPersistentManifold& manifold) const {
        return std::any_of(known_.begin(), known_.end(), [&](const Landing& known) {
            return !known.is_refused && known.holds(manifold, isExtra(manifold));
        });
    }

    /// None if neither body lands, or not on flat ground.
    std::vector<btManifoldPoint> pointsOf(const btPersistentManifold& manifold, btScalar reach) {
        for (const bool a_lands : {true, false}) {
            const btCollisionObject &landing = *(a_lands ? manifold.getBody0() : manifold.getBody1()),
                                    &ground = *(a_lands ? manifold.getBody1() : manifold.getBody0());
            const LandingBody body = collector_.landing(landing);
            Landing known{manifold.getBody0(), manifold.getBody1(), a_lands,
                          childOfGround(manifold, a_lands)};
            const auto isTheSame = [&](const Landing& other) {
                return other.is_refused && other.a_lands == a_lands && other.holds(manifold, false);
            };
            if (!body.outermost || std::any_of(known_.begin(), known_.end(), isTheSame)) continue;
            auto points = landingPoints(manifold, body, a_lands, collector_.stoodAt(ground), reach);
            known.is_refused = !points || points->empty();
            known_.push_back(known);
            if (known.is_refused) continue;
            shareOut(known, *points);
            return *std::move(points);
        }
        return {};
    }

  private:
    struct Landing {
        const btCollisionObject *a, *b;
        bool a_lands;
        int child;  // of the ground
        bool is_refused = false;

        bool holds(const btPersistentManifold& manifold, bool on_any_child) const {
            return a == manifold.getBody0() && b == manifold.getBody1() &&
                   (on_any_child || child == childOfGround(manifold, a_lands));
        }
    };
    static int childOfGround(const btPersistentManifold& manifold, bool a_lands) {
        const btManifoldPoint& first = manifold.getContactPoint(0);
        return a_lands ? first.m_index1 : first.m_index0;
    }

    /// Gives the impulses of all manifolds of the landing to the points that touch first.
    void shareOut(const Landing& landing, std::vector<btManifoldPoint>& deepest_first) const {
        constexpr btScalar rounding = btScalar(1e-6);  // m
        const btScalar deepest = deepest_first.front().getDistance();
        const auto later = std::find_if(
            deepest_first.begin(), deepest_first.end(),
            [&](const btManifoldPoint& point) { return point.getDistance() > deepest + rounding; });
        std::vector<btManifoldPoint> first(deepest_first.begin(), later);
        for (const btPersistentManifold* manifold : solved_)
            if (landing.holds(*manifold, isExtra(*manifold)))
                for (int i = 0; i < manifold->getNumContacts(); ++i)
                    share(manifold->getContactPoint(i), first);
        std::copy(first.begin(), first.end(), deepest_first.begin());
    }

    const std::vector<btPersistentManifold*>& solved_;
    const ContactCollector& collector_;
    std::vector<Landing> known_;
};

/// What is known of how the bodies of a manifold met.
enum class Meeting {
    found,       ///< where they are
    predictive,  ///< where they will be
    on_the_way,  ///< where they were
};

/// The points of a manifold, as Bullet has them, and the vertices that it lacks.
std::vector<btManifoldPoint> solvedPoints(const btPersistentManifold& manifold, Meeting meeting, bool rests,
                                          std::vector<btManifoldPoint> missed,
                                          const ContactCollector& collector) {
    const bool predictive = meeting == Meeting::predictive;
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    std::vector<btManifoldPoint> points;
    points.reserve(MANIFOLD_CACHE_SIZE + missed.size());
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint point = manifold.getContactPoint(i);
        if (point.getDistance() > manifold.getContactProcessingThreshold()) continue;
        if (!predictive && isBetween(point, missed, !rests && isOnFace(point, *a, *b))) {
            share(point, missed);
            continue;
        }
        if (predictive) {
            moveToSurface(point, *a);
            point.m_index0 = point.m_index1 = -1;
        }
        if (meeting == Meeting::found) moveToBall(point, *a, *b, collector);
        points.push_back(point);
    }
    points.insert(points.end(), missed.begin(), missed.end());
    return points;
}

void feedManifold(btPersistentManifold& found, Meeting meeting, Landings& landings,
                  ContactCollector& collector) {
    const bool predictive = meeting == Meeting::predictive;
    const btCollisionObject *a = found.getBody0(), *b = found.getBody1();
    const btTransform &stood_a = collector.stoodAt(*a), &stood_b = collector.stoodAt(*b);
    const btCollisionObjectWrapper wrapper_a(nullptr, a->getCollisionShape(), a, a->getWorldTransform(), -1,
                                             -1);
    const btCollisionObjectWrapper wrapper_b(nullptr, b->getCollisionShape(), b, b->getWorldTransform(), -1,
                                             -1);
    const bool rests = !predictive && !collector.mayStrike(found);
    const auto straight =
        predictive || rests || isExtra(found) ? nullptr : onBoxFaces(found, stood_a, stood_b);
    const btPersistentManifold& manifold = straight ? *straight : found;
    const btScalar tolerance = toleranceOf(found, collector);
    const bool of_whole = collector.isOfWhole(found);
    std::vector<btManifoldPoint> points;
    if (meeting == Meeting::found && !rests) {
        if (landings.know(manifold)) return;
        if (!isExtra(found)) points = landings.pointsOf(manifold, tolerance);
    }
    const bool is_known = !points.empty();
    if (!is_known) {
        std::vector<btManifoldPoint> vertices;
        if (!isExtra(found))  // else Bullet's own manifold of the pair lacks the same ones
            vertices = rests ? missedVertices(manifold, stood_a, stood_b, {btScalar(largestRestingGap())})
                             : landedVertices(manifold, stood_a, stood_b, tolerance, of_whole);
        points = solvedPoints(manifold, meeting, rests, std::move(vertices), collector);
    }
    if (rests) {
        pressEvenly(points);
    } else if (!predictive) {
        if (!is_known) meetTogether(points, tolerance);
        pressLanding(points, *a, *b, collector);
    }
    FacesOfContact faces;
    if (!rests && of_whole && !points.empty()) {
        const btManifoldPoint& first = points.front();
        const btVector3& normal = first.m_normalWorldOnB;
        faces.of_a = faceThatTouches(*a, stood_a, first.m_index0, -normal, first.m_positionWorldOnA);
        faces.of_b = faceThatTouches(*b, stood_b, first.m_index1, normal, first.m_positionWorldOnB);
    }
    collector.setFaces(std::move(faces));
    for (btManifoldPoint& point : points)
        collector.addSingleResult(point, &wrapper_a, point.m_partId0, point.m_index0, &wrapper_b,
                                  point.m_partId1, point.m_index1);
}

}  // namespace

void feedSolvedContacts(btDiscreteDynamicsWorld& world, ContactCollector& collector) {
    btDispatcher& dispatcher = *world.getDispatcher();
    std::vector<btPersistentManifold*> solved;
    solved.reserve(static_cast<std::size_t>(dispatcher.getNumManifolds()));
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
        if (manifold->getNumContacts() == 0) continue;
        const btCollisionObject *a = manifold->getBody0(), *b = manifold->getBody1();
        // Predictive manifolds outlive bodies that the app takes out while the step is solved.
        if (a->getWorldArrayIndex() < 0 || b->getWorldArrayIndex() < 0) continue;
        if ((a->isActive() || b->isActive()) && dispatcher.needsResponse(a, b)) solved.push_back(manifold);
    }
    const std::vector<const btPersistentManifold*> foreseen = predictiveContacts(world);
    std::vector<std::unique_ptr<btPersistentManifold>> corrected;
    std::vector<std::pair<btPersistentManifold**, btPersistentManifold*>> replaced;
    for (btPersistentManifold*& manifold : solved) {
        if (isAmong(foreseen, manifold)) continue;
        if (auto met = collector.corrected(*manifold)) {
            corrected.push_back(std::move(met));
            replaced.emplace_back(&manifold, manifold);
            manifold = corrected.back().get();
        }
    }
    // What lies as deep in others, and did so before, has not met the side of the next one.
    for (const auto& [place, own] : replaced)
        if (isSunkBeside(*own, solved)) *place = own;
    for (const btPersistentManifold* manifold : solved) collector.expect(*manifold);
    collector.lookForPiles({solved.begin(), solved.end()}, foreseen);
    Landings landings(solved, collector);
    for (btPersistentManifold* manifold : solved) {
        if (!collector.listensTo(*manifold)) continue;
        const bool is_corrected = std::any_of(corrected.begin(), corrected.end(),
                                              [&](const auto& own) { return own.get() == manifold; });
        feedManifold(*manifold,
                     is_corrected                  ? Meeting::on_the_way
                     : isAmong(foreseen, manifold) ? Meeting::predictive
                                                   : Meeting::found,
                     landings, collector);
    }
}

}  // namespace sherd
