#include "bullet/convex_hull.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cmath>

#include "bullet/conversions.h"

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

/// Directions spread evenly over the sphere by a Fibonacci lattice.
Eigen::Vector3f direction(int index, int count) {
    const double golden_angle = std::acos(-1.0) * (3 - std::sqrt(5.0));
    const double z = 1 - (2 * index + 1.0) / count, r = std::sqrt(1 - z * z);
    return Vec3(r * std::cos(golden_angle * index), r * std::sin(golden_angle * index), z).cast<float>();
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

ConvexHull roughHull(const std::vector<Vec3>& points, int directions) {
    if (static_cast<int>(points.size()) <= directions) return convexHull(points);
    const auto count = static_cast<Eigen::Index>(points.size());
    // One column for each coordinate, so that the products below run over the points.
    Eigen::MatrixX3f coordinates =
        Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, count).transpose().cast<float>();
    Eigen::VectorXf heights(count);
    std::vector<Eigen::Index> outermost;
    for (int i = 0; i < directions; ++i) {
        heights.noalias() = coordinates * direction(i, directions);
        const float* const highest = std::find(heights.data(), heights.data() + count, heights.maxCoeff());
        outermost.push_back(highest - heights.data());
    }
    std::sort(outermost.begin(), outermost.end());
    outermost.erase(std::unique(outermost.begin(), outermost.end()), outermost.end());
    std::vector<Vec3> few;
    for (const Eigen::Index place : outermost) few.push_back(points[static_cast<std::size_t>(place)]);
    return convexHull(few);
}

}  // namespace sherd
