#include "geometry/solid_union.h"

#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "geometry/canonical_hull.h"
#include "geometry/exact_union.h"
#include "geometry/surface_checks.h"
#include "geometry/surface_topology.h"

namespace sherd {
namespace {

using Parts = std::vector<std::vector<Vec3>>;

constexpr double weld_tolerance = 1e-6;  // of the whole; a float keeps 6e-8

/// Makes coordinates along one axis equal that are nearly so.
void weldAxis(Parts& parts, int axis, double tolerance) {
    std::vector<double*> values;
    for (auto& part : parts)
        for (Vec3& point : part) values.push_back(&point[axis]);
    std::sort(values.begin(), values.end(), [](const double* a, const double* b) { return *a < *b; });
    double level = *values.front();
    for (double* value : values)
        if (*value - level <= tolerance)
            *value = level;
        else
            level = *value;
}

Status weld(Parts& parts) {
    Eigen::AlignedBox3d box;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].empty()) return Error{"Convex part " + std::to_string(p) + " has no points; remove it."};
        for (const Vec3& point : parts[p]) {
            if (!point.allFinite())
                return Error{"Convex part " + std::to_string(p) + " has a point at " + describePlace(point) +
                             ", which is not finite; correct it."};
            box.extend(point);
        }
    }
    for (int axis = 0; axis < 3; ++axis) weldAxis(parts, axis, weld_tolerance * box.diagonal().norm());
    return success();
}

std::optional<ExactMesh> convexHull(const std::vector<Vec3>& points) {
    std::vector<ExactKernel::Point_3> exact;
    for (const Vec3& point : points) exact.emplace_back(point.x(), point.y(), point.z());
    ExactMesh hull;
    CGAL::convex_hull_3(exact.begin(), exact.end(), hull);
    if (hull.number_of_faces() < 4 || !CGAL::is_closed(hull)) return std::nullopt;
    return canonicalHull(hull);
}

/// Adds `part` to `whole` if their union is a manifold; false if not.
bool unite(ExactMesh& whole, const ExactMesh& part) {
    std::optional<ExactMesh> both = unionOf(whole, part);
    if (both) whole = std::move(*both);
    return both.has_value();
}

Result<ExactMesh> uniteHulls(const Parts& parts) {
    std::vector<std::pair<std::size_t, ExactMesh>> waiting;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        std::optional<ExactMesh> hull = convexHull(parts[p]);
        if (!hull)
            return Error{"Convex part " + std::to_string(p) + " is flat; give it a thickness, or remove it."};
        waiting.emplace_back(p, std::move(*hull));
    }
    ExactMesh whole;
    // Two parts may touch in an edge only until a third fills the corner, so what fails waits for the next
    // round.
    for (bool progress = true; progress && !waiting.empty();) {
        std::vector<std::pair<std::size_t, ExactMesh>> failed;
        for (auto& [number, part] : waiting)
            if (!unite(whole, part)) failed.emplace_back(number, std::move(part));
        progress = failed.size() < waiting.size();
        waiting = std::move(failed);
    }
    if (waiting.empty()) return whole;
    return Error{"Convex part " + std::to_string(waiting.front().first) +
                 " touches the others in an edge or a point only, so the union is no solid; let parts "
                 "overlap, meet in "
                 "faces, or stay apart."};
}

/// Scales every part up by a few millionths, each by another factor, so that faces nearly in one plane are
/// apart by more than rounding to double precision.
void growUnevenly(Parts& parts) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const double growth =
            weld_tolerance * (1 + std::fmod(0.6180339887498949 * static_cast<double>(p), 1));
        Vec3 centre = Vec3::Zero();
        for (const Vec3& point : parts[p]) centre += point / static_cast<double>(parts[p].size());
        for (Vec3& point : parts[p]) point += growth * (point - centre);
    }
}

Result<TriangleMesh> uniteAll(Parts parts) {
    if (parts.empty()) return Error{"There are no convex parts to unite; give at least one."};
    if (Status welded = weld(parts); !welded) return Error{welded.error()};
    Status checked = success();
    for (int attempt = 0; attempt < 2; ++attempt) {
        const Result<ExactMesh> whole = uniteHulls(parts);
        if (!whole) return Error{whole.error()};
        TriangleMesh mesh = roundedMesh(whole.value());
        checked = checkSurface(mesh);
        if (checked) return mesh;
        if (!closedManifoldEdges(mesh)) break;  // parts that touch in a point; growth would only hide it
        growUnevenly(parts);
    }
    return Error{"The union of the convex parts is no solid: " + checked.error()};
}

}  // namespace

Result<TriangleMesh> uniteConvexParts(const std::vector<std::vector<Vec3>>& hull_points_of_parts) {
    try {
        return uniteAll(hull_points_of_parts);
    } catch (const std::exception& fault) {
        return Error{std::string("The convex parts could not be united: ") + fault.what() + "."};
    }
}

}  // namespace sherd
