#include "core/loads/surface_region.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/loads/region_checks.h"
#include "core/loads/region_parts.h"
#include "core/numerics/mesh_measures.h"

namespace sherd {

namespace {

constexpr double points_across = 8;  // at least, over the root of a region's area
constexpr double most_points = 1e6;  // about, of a flat region

/// Merges the quadrature points that lie in the same cube of a grid and face alike into one.
class MergingGrid {
  public:
    MergingGrid(const Vec3& origin, double size) : origin_(origin), size_(size) {}

    double size() const { return size_; }

    void add(const Vec3& position, const Vec3& area) {
        const double a = area.norm();
        if (!(a > 0)) return;
        Key key;
        for (int k = 0; k < 3; ++k) {
            key[k] = static_cast<long long>(std::floor((position[k] - origin_[k]) / size_));
            key[3 + k] = std::llround(2 * area[k] / a);
        }
        AreaPoint& sum = sums_[key];
        sum.position += a * position;
        sum.area += area;
        sum.area_m2 += a;
    }

    std::vector<AreaPoint> points() const {
        std::vector<AreaPoint> all;
        for (const auto& [key, sum] : sums_)
            all.push_back({sum.position / sum.area_m2, sum.area, sum.area_m2});
        return all;
    }

  private:
    using Key = std::array<long long, 6>;  // cube, and twice the normal, rounded
    Vec3 origin_;
    double size_;
    std::map<Key, AreaPoint> sums_;
};

/// One point a triangle; a triangle longer than a cube of the grid is first halved across its longest edge.
void addTriangle(const TriangleCorners& t, MergingGrid& grid) {
    int longest = 0;
    const auto length = [&](int edge) { return (t[(edge + 1) % 3] - t[edge]).squaredNorm(); };
    for (int edge = 1; edge < 3; ++edge)
        if (length(edge) > length(longest)) longest = edge;
    if (length(longest) <= grid.size() * grid.size())
        return grid.add((t[0] + t[1] + t[2]) / 3, areaVector(t));
    const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
    const Vec3 half = 0.5 * (a + b);
    addTriangle({a, half, c}, grid);
    addTriangle({half, b, c}, grid);
}

}  // namespace

Result<std::vector<AreaPoint>> regionQuadrature(const TriangleMesh& surface, const SurfaceRegion& region,
                                                double size) {
    if (const Status sound = checkRegion(region); !sound) return Error{sound.error()};
    const std::vector<ConvexPolygon> parts = partsInside(surface, region);
    double area = 0;
    for (const ConvexPolygon& part : parts) area += areaOf(part);
    const Eigen::AlignedBox3d box = boundingBox(surface.vertices);
    if (!(area > 0))
        return Error{"No part of the surface lies in " + describe(region) + "; the body fills " +
                     describe(BoxRegion{box.min(), box.max()}) + "."};
    MergingGrid grid(
        box.min(), std::max(std::min(size, std::sqrt(area) / points_across), std::sqrt(area / most_points)));
    for (const ConvexPolygon& part : parts)
        for (std::size_t i = 2; i < part.size(); ++i) addTriangle({part[0], part[i - 1], part[i]}, grid);
    return grid.points();
}

void AreaSpread::add(const TriangleMesh& surface, const SurfaceRegion& region) {
    if (!checkRegion(region)) return;
    for (const ConvexPolygon& part : partsInside(surface, region))
        for (std::size_t i = 2; i < part.size(); ++i) {
            const TriangleCorners t{part[0] - origin_, part[i - 1] - origin_, part[i] - origin_};
            const double a = areaVector(t).norm();
            const Vec3 sum = t[0] + t[1] + t[2];
            area_ += a;
            first_ += a / 3 * sum;
            second_ += a / 12 * sum * sum.transpose();
            for (const Vec3& corner : t) second_ += a / 12 * corner * corner.transpose();
        }
}

double AreaSpread::width_m() const {
    if (!(area_ > 0)) return 0;
    const Mat3 spread = second_ / area_ - first_ * first_.transpose() / (area_ * area_);
    const double variance =
        Eigen::SelfAdjointEigenSolver<Mat3>(spread, Eigen::EigenvaluesOnly).eigenvalues()[1];
    return std::sqrt(12 * std::max(0.0, variance));
}

AreaSpread spreadOf(const TriangleMesh& surface, const SurfaceRegion& region) {
    AreaSpread spread(boundingBox(surface).center());
    spread.add(surface, region);
    return spread;
}

std::vector<PointForce> pointForces(const SurfaceLoad& load, const std::vector<AreaPoint>& points) {
    double area = 0;
    for (const AreaPoint& p : points) area += p.area_m2;
    std::vector<PointForce> forces;
    for (const AreaPoint& p : points)
        forces.push_back({p.position, load.force_n * (p.area_m2 / area) - load.pressure_pa * p.area});
    return forces;
}

}  // namespace sherd
