#include "bullet/convex_hull.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bullet/conversions.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {

namespace {

constexpr int most_rounds = 4;  // of adding points outside the faces

/// A face of a hull.
struct Face {
    Vec3 normal;  // outward, unit
    double height = 0;
};

/// Visits the corners of each face of a hull in order.
template <class Visit>
void forEachFace(const btConvexHullComputer& hull, const Visit& visit) {
    std::vector<Vec3> corners;
    for (int f = 0; f < hull.faces.size(); ++f) {
        corners.clear();
        const btConvexHullComputer::Edge* const first = &hull.edges[hull.faces[f]];
        const auto* edge = first;
        do {
            corners.push_back(fromBullet(hull.vertices[edge->getSourceVertex()]));
            edge = edge->getNextEdgeOfFace();
        } while (edge != first);
        visit(corners);
    }
}

Vec3 areaVectorOf(const std::vector<Vec3>& corners) {
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 2; i < corners.size(); ++i)
        area += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
    return area / 2;
}

double enclosedVolume(const btConvexHullComputer& hull) {
    if (hull.vertices.size() == 0) return 0;
    const Vec3 origin = fromBullet(hull.vertices[0]);
    double three_volumes = 0;
    forEachFace(hull, [&](const std::vector<Vec3>& corners) {
        three_volumes += areaVectorOf(corners).dot(corners[0] - origin);
    });
    return std::abs(three_volumes) / 3;
}

void compute(btConvexHullComputer& computer, const std::vector<Vec3>& points) {
    computer.compute(points.front().data(), sizeof(Vec3), static_cast<int>(points.size()), 0, 0);
}

ConvexHull result(const btConvexHullComputer& computer) {
    ConvexHull hull;
    for (int v = 0; v < computer.vertices.size(); ++v)
        hull.vertices.push_back(fromBullet(computer.vertices[v]));
    hull.volume = enclosedVolume(computer);
    return hull;
}

/// The faces of a hull that have an area.
std::vector<Face> facesOf(const btConvexHullComputer& hull) {
    Vec3 inside = Vec3::Zero();
    for (int v = 0; v < hull.vertices.size(); ++v) inside += fromBullet(hull.vertices[v]);
    inside /= std::max(hull.vertices.size(), 1);
    std::vector<Face> faces;
    forEachFace(hull, [&](const std::vector<Vec3>& corners) {
        const Vec3 area = areaVectorOf(corners);
        if (!(area.squaredNorm() > 0)) return;
        Face face{area.normalized(), 0};
        if (face.normal.dot(corners[0] - inside) < 0) face.normal = -face.normal;
        face.height = face.normal.dot(corners[0]);
        faces.push_back(face);
    });
    return faces;
}

constexpr long block = 64;

/// The highest and the lowest of some numbers.
SHERD_WIDE_VECTORS void findExtremes(const float* heights, long count, float* highest, float* lowest) {
    float high[block], low[block];
    for (long i = 0; i < block; ++i) high[i] = low[i] = heights[0];
    long first = 0;
    for (; first + block <= count; first += block)
        for (long i = 0; i < block; ++i) {
            const float height = heights[first + i];
            high[i] = height > high[i] ? height : high[i];
            low[i] = height < low[i] ? height : low[i];
        }
    *highest = *std::max_element(high, high + block);
    *lowest = *std::min_element(low, low + block);
    for (; first < count; ++first) {
        *highest = std::max(*highest, heights[first]);
        *lowest = std::min(*lowest, heights[first]);
    }
}

/// The place of the first number that is `wanted`; one is.
SHERD_WIDE_VECTORS long firstPlace(const float* heights, long count, float wanted) {
    long first = 0;
    for (; first + block <= count; first += block) {
        int found = 0;
        for (long i = 0; i < block; ++i) found |= heights[first + i] == wanted ? 1 : 0;
        if (found) break;
    }
    while (heights[first] != wanted) ++first;
    return first;
}

/// Points with a column for each coordinate, about the middle of their box.
class Columns {
  public:
    Columns(const std::vector<Vec3>& points, const Eigen::AlignedBox3d& box) : box_(box) {
        middle_ = box_.center();
        coordinates_.resize(static_cast<Eigen::Index>(points.size()), 3);
        for (Eigen::Index d = 0; d < 3; ++d)
            for (std::size_t p = 0; p < points.size(); ++p)
                coordinates_(static_cast<Eigen::Index>(p), d) = static_cast<float>(points[p][d] - middle_[d]);
        place_.resize(points.size());
        std::iota(place_.begin(), place_.end(), 0);
    }

    /// The outermost points in 26 directions to the sides, edges and corners of the box, each once.
    std::vector<int> outermost() {
        std::vector<int> found;
        const Vec3 stretch = (box_.sizes().array().max(1e-30)).inverse();
        for (int d = 14; d < 27; ++d) {  // of 3 x 3 x 3, one of each opposite two
            const Vec3 way(d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1);
            heights_.noalias() = coordinates_ * way.cwiseProduct(stretch).cast<float>();
            float highest, lowest;
            findExtremes(heights_.data(), heights_.size(), &highest, &lowest);
            found.push_back(place_[firstPlace(heights_.data(), heights_.size(), highest)]);
            found.push_back(place_[firstPlace(heights_.data(), heights_.size(), lowest)]);
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    /// The point that is furthest outside a face, and how far; none if that is less than `tolerance`.
    struct Furthest {
        int point = -1;
        double distance = 0;
    };
    Furthest furthest(const Face& face, double tolerance) {
        const auto height = static_cast<float>(face.height - face.normal.dot(middle_));
        heights_.noalias() = coordinates_ * face.normal.cast<float>();
        outside_ = outside_.max(heights_.array() - height);
        const float highest = heights_.maxCoeff();
        if (!(highest - height > tolerance)) return {};
        return {place_[firstPlace(heights_.data(), heights_.size(), highest)], highest - height};
    }
    void beginRound() { outside_.setConstant(coordinates_.rows(), 0.f); }
    /// Leaves out what no face has further outside than `tolerance`: it stays inside while the hull grows.
    void keepOutside(double tolerance) {
        Eigen::Index kept = 0;
        for (Eigen::Index p = 0; p < coordinates_.rows(); ++p) {
            if (!(outside_[p] > tolerance)) continue;
            coordinates_.row(kept) = coordinates_.row(p).eval();
            place_[kept++] = place_[p];
        }
        coordinates_.conservativeResize(kept, 3);
        place_.resize(kept);
    }
    bool empty() const { return place_.empty(); }

  private:
    Eigen::AlignedBox3d box_;
    Vec3 middle_;
    Eigen::MatrixX3f coordinates_;
    std::vector<int> place_;  // among the points given
    Eigen::VectorXf heights_;
    Eigen::ArrayXf outside_;
};

std::vector<Vec3> picked(const std::vector<Vec3>& points, const std::vector<int>& which) {
    std::vector<Vec3> result;
    for (const int place : which) result.push_back(points[place]);
    return result;
}

}  // namespace

ConvexHull convexHull(const std::vector<Vec3>& points) {
    if (points.empty()) return {};
    btConvexHullComputer computer;
    compute(computer, points);
    return result(computer);
}

double roughHullVolume(const std::vector<Vec3>& points, const Eigen::AlignedBox3d& box) {
    if (points.empty()) return 0;
    btConvexHullComputer computer;
    compute(computer, picked(points, Columns(points, box).outermost()));
    return enclosedVolume(computer);
}

ConvexHull simpleHull(const std::vector<Vec3>& points, int most_vertices, double tolerance_m) {
    if (points.empty()) return {};
    Columns columns(points, boundingBox(points));
    std::vector<int> chosen = columns.outermost();
    btConvexHullComputer computer;
    double outside = 0;
    for (int round = 0; round < most_rounds; ++round) {
        compute(computer, picked(points, chosen));
        outside = 0;
        columns.beginRound();
        std::vector<Columns::Furthest> more;
        for (const Face& face : facesOf(computer)) {
            const Columns::Furthest furthest = columns.furthest(face, tolerance_m);
            if (furthest.point >= 0) more.push_back(furthest);
            outside = std::max(outside, furthest.distance);
        }
        const int room = most_vertices - static_cast<int>(chosen.size());
        if (more.empty() || room <= 0 || round + 1 == most_rounds) break;
        std::sort(more.begin(), more.end(), [](const auto& a, const auto& b) {
            return a.distance != b.distance ? a.distance > b.distance : a.point < b.point;
        });
        for (const Columns::Furthest& next : more) {
            if (static_cast<int>(chosen.size()) == most_vertices) break;
            if (std::find(chosen.begin(), chosen.end(), next.point) == chosen.end())
                chosen.push_back(next.point);
        }
        columns.keepOutside(tolerance_m);
    }
    ConvexHull hull = result(computer);
    hull.outside = outside;
    return hull;
}

}  // namespace sherd
