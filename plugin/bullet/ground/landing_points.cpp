#include "bullet/ground/landing_points.h"

#include <algorithm>

#include "bullet/ground/even_ground.h"

namespace sherd {

namespace {

constexpr std::size_t most_points = 32;        // each takes near a millisecond of a blow
constexpr btScalar parallel = btScalar(1e-6);  // of the cosine
constexpr btScalar level_m = btScalar(1e-5);

/// Whether two parts of ground are one plane at a place, but for rounding.
bool areOnePlane(const Facet& a, const Facet& b, const btVector3& place) {
    const btScalar rounding = 4 * SIMD_EPSILON * place.length();
    return a.normal.dot(b.normal) >= 1 - parallel &&
           btFabs(a.above(place) - b.above(place)) <= level_m + rounding;
}

struct Vertex {
    btVector3 place;  // world frame
    btScalar height;
};

using Vertices = std::vector<Vertex>;

/// Adds the first ones of a range, each at least so far from the others; one more than there may be at most.
void spreadOut(Vertices::const_iterator begin, Vertices::const_iterator end, btScalar apart, Vertices& kept) {
    for (auto vertex = begin; vertex != end && kept.size() <= most_points; ++vertex) {
        const bool is_near = std::any_of(kept.begin(), kept.end(), [&](const Vertex& other) {
            return (vertex->place - other.place).length2() < apart * apart;
        });
        if (!is_near) kept.push_back(*vertex);
    }
}

/// Of those that touch together with the deepest some all over, of those that do so later the first ones: the
/// deeper the step takes the body in, the more of these there are, and they have no part in the blow.
Vertices mostOf(const Vertices& deepest_first, btScalar together, btScalar apart) {
    const auto begin = deepest_first.begin(), end = deepest_first.end();
    if (begin == end) return {};
    const auto later = std::find_if(begin, end, [&](const Vertex& vertex) {
        return vertex.height > deepest_first.front().height + together;
    });
    Vertices kept;
    for (btScalar further = apart;; further *= 2) {
        kept.clear();
        spreadOut(begin, later, further, kept);
        if (kept.size() <= most_points) break;
    }
    spreadOut(later, end, apart, kept);
    if (kept.size() > most_points) kept.pop_back();
    return kept;
}

}  // namespace

std::optional<std::vector<btManifoldPoint>> landingPoints(const btPersistentManifold& manifold,
                                                          const LandingBody& body, bool body_is_a,
                                                          const btTransform& ground_stood, btScalar reach) {
    if (manifold.getNumContacts() == 0) return std::nullopt;
    const EvenGround ground = evenGround(body.shape, manifold, body_is_a, ground_stood, body.inside, true);
    const btManifoldPoint& first = manifold.getContactPoint(0);
    const Facet* face = ground.under(body_is_a ? first.m_positionWorldOnB : first.m_positionWorldOnA);
    if (!face) return std::nullopt;
    const btTransform& stood = body.shape.transform;
    const btVector3 up = face->normal * stood.getBasis();  // in the body's frame
    const btScalar height_of_body = face->above(stood.getOrigin());
    btScalar deepest = BT_LARGE_FLOAT;
    for (const btVector3& own : *body.outermost) deepest = std::min(deepest, up.dot(own));
    const btScalar highest = std::max(height_of_body + deepest, btScalar(0)) + reach;
    std::vector<Vertex> vertices;
    for (const btVector3& own : *body.outermost) {
        const btScalar height = height_of_body + up.dot(own);
        if (height >= highest) continue;
        const btVector3 place = stood * own;
        const Facet* below = ground.under(place);
        if (!below || !areOnePlane(*below, *face, place)) return std::nullopt;
        vertices.push_back({place, height});
    }
    std::stable_sort(vertices.begin(), vertices.end(),
                     [](const Vertex& a, const Vertex& b) { return a.height < b.height; });
    std::vector<btManifoldPoint> points;
    for (const Vertex& vertex : mostOf(vertices, std::max(reach, level_m), body.spacing / 2)) {
        const btVector3 below = vertex.place - vertex.height * face->normal;
        btManifoldPoint point = first;
        point.m_normalWorldOnB = body_is_a ? face->normal : -face->normal;
        point.m_positionWorldOnA = body_is_a ? vertex.place : below;
        point.m_positionWorldOnB = body_is_a ? below : vertex.place;
        point.m_distance1 = vertex.height;
        point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
        points.push_back(point);
    }
    return points;
}

}  // namespace sherd
