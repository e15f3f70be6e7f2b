#include "convex_hull.h"

#include <LinearMath/btConvexHull.h>
#include <LinearMath/btConvexHullComputer.h>

#include "conversions.h"

namespace sherd {

namespace {

double enclosedVolume(const btConvexHullComputer& hull) {
    if (hull.vertices.size() == 0) return 0;
    const Vec3 origin = fromBullet(hull.vertices[0]);
    const auto corner = [&](int vertex) { return Vec3(fromBullet(hull.vertices[vertex]) - origin); };
    double six_volumes = 0;
    for (int f = 0; f < hull.faces.size(); ++f) {
        const btConvexHullComputer::Edge* const first = &hull.edges[hull.faces[f]];
        const Vec3 a = corner(first->getSourceVertex());
        for (const auto* edge = first->getNextEdgeOfFace();
             edge->getTargetVertex() != first->getSourceVertex(); edge = edge->getNextEdgeOfFace())
            six_volumes += a.dot(corner(edge->getSourceVertex()).cross(corner(edge->getTargetVertex())));
    }
    return std::abs(six_volumes) / 6;
}

}  // namespace

ConvexHull convexHull(const std::vector<Vec3>& points) {
    ConvexHull hull;
    if (points.empty()) return hull;
    btConvexHullComputer computer;
    computer.compute(points.front().data(), sizeof(Vec3), static_cast<int>(points.size()), 0, 0);
    for (int v = 0; v < computer.vertices.size(); ++v)
        hull.vertices.push_back(fromBullet(computer.vertices[v]));
    hull.volume = enclosedVolume(computer);
    return hull;
}

ConvexHull thinnedHull(const ConvexHull& hull, int most) {
    if (static_cast<int>(hull.vertices.size()) <= most) return hull;
    std::vector<btVector3> points;
    for (const Vec3& vertex : hull.vertices) points.push_back(toBullet(vertex));
    HullDesc wish(QF_TRIANGLES, static_cast<unsigned>(points.size()), points.data());
    wish.mMaxVertices = static_cast<unsigned>(most);
    HullLibrary library;
    HullResult found;
    std::vector<Vec3> kept;
    if (library.CreateConvexHull(wish, found) == QE_OK)
        for (unsigned v = 0; v < found.mNumOutputVertices; ++v)
            kept.push_back(fromBullet(found.m_OutputVertices[static_cast<int>(v)]));
    library.ReleaseResult(found);
    ConvexHull thinned = convexHull(kept);
    return thinned.volume > 0 ? thinned : hull;
}

}  // namespace sherd
