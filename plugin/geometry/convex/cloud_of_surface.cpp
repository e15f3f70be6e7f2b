// The cloud of points that stands for a surface.

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/numerics/mesh_measures.h"
#include "geometry/convex/surface_cloud.h"

namespace sherd {

namespace {

constexpr double spacings_across = 16;          // between points of large triangles, across the box
constexpr int most_divisions = 16;              // of a triangle's sides
constexpr std::size_t most_points = 600;        // about; vertices beyond are taken together
constexpr std::size_t most_even_points = 8000;  // on large triangles; beyond, they are taken together
constexpr std::size_t most_on_slivers = 3000;   // the same of those on long and narrow ones
constexpr int cells_across = 16;                // in which points are taken together, across the box
constexpr double just_inside = 1e-6;            // of the spacing
constexpr double facing = 0.99;                 // cosine, from which on a face lies across an axis
constexpr int places = 1024;                    // along the box at which the areas of steps are added up
constexpr double smallest_step = 0.02;          // of the section of the box

bool liesAcrossAny(const Vec3& area) {
    return area.cwiseAbs2().maxCoeff() > facing * facing * area.squaredNorm();
}

/// Which points of a cloud stand for the vertices of a surface.
class Representatives {
  public:
    Representatives(const TriangleMesh& surface, const Eigen::AlignedBox3d& box, SurfaceCloud& cloud)
        : surface_(surface), low_(box.min()), cloud_(cloud), of_vertex_(surface.vertices.size(), -1) {
        if (surface.vertices.size() <= most_points) return;
        cell_ = box.sizes().maxCoeff() / cells_across;
        of_cell_.assign((cells_across + 1) * (cells_across + 1) * (cells_across + 1), -1);
    }
    int of(int vertex) {
        int& known = of_vertex_[vertex];
        if (known >= 0) return known;
        const Vec3& x = surface_.vertices[vertex];
        if (of_cell_.empty()) return known = add(x);
        const Eigen::Vector3i i = ((x - low_) / cell_).cast<int>();
        int& place = of_cell_[(i.z() * (cells_across + 1) + i.y()) * (cells_across + 1) + i.x()];
        if (place < 0) place = add(x);
        return known = place;
    }
    int add(const Vec3& x) {
        cloud_.points.push_back(x);
        cloud_.areas.push_back(Vec3::Zero());
        return static_cast<int>(cloud_.points.size()) - 1;
    }

  private:
    const TriangleMesh& surface_;
    Vec3 low_;
    SurfaceCloud& cloud_;
    double cell_ = 0;
    std::vector<int> of_vertex_, of_cell_;
};

/// Adds up the areas of faces that lie across an axis.
class Steps {
  public:
    explicit Steps(const Eigen::AlignedBox3d& box) : box_(box) {
        for (auto& sums : sums_) sums.resize(places + 1);
    }
    void add(const TriangleCorners& x, const Vec3& area) {
        int axis;
        const double across = area.cwiseAbs().maxCoeff(&axis);
        const double offset = (x[0][axis] + x[1][axis] + x[2][axis]) / 3;
        const double place = (offset - box_.min()[axis]) / box_.sizes()[axis];
        if (!(place >= 0 && place <= 1)) return;
        Sum& sum = sums_[axis][static_cast<int>(std::lround(place * places))];
        sum.area += across;
        sum.moment += across * offset;
    }
    std::vector<SurfaceCloud::Step> along(int axis) const {
        const double enough = smallest_step * box_.volume() / box_.sizes()[axis];
        std::vector<SurfaceCloud::Step> steps;
        for (const Sum& sum : sums_[axis])
            if (sum.area > enough) steps.push_back({sum.moment / sum.area, sum.area});
        return steps;
    }

  private:
    struct Sum {
        double area = 0, moment = 0;
    };
    Eigen::AlignedBox3d box_;
    std::array<std::vector<Sum>, 3> sums_;
};

/// The square of a triangle's longest side, m^2.
double longestSquare(const Vec3& side, const Vec3& other) {
    return std::max({side.squaredNorm(), other.squaredNorm(), (other - side).squaredNorm()});
}

double shortestSquare(const Vec3& side, const Vec3& other) {
    return std::min({side.squaredNorm(), other.squaredNorm(), (other - side).squaredNorm()});
}

/// Of a triangle's sides, so that points on it are no further apart than `spacing`.
int divisionsOf(double longest, double spacing) {
    if (longest < spacing * spacing) return 1;
    return std::clamp(static_cast<int>(std::sqrt(longest) / spacing) + 1, 1, most_divisions);
}

int evenCount(int divisions) {
    return (divisions + 1) * (divisions + 2) / 2;
}

/// Calls visit(x) for points all over a triangle. Not on the sides, which may lie in a plane that cuts.
template <class Visit>
void forEvenPoints(const TriangleCorners& x, int divisions, const Visit& visit) {
    const Vec3 centre = (x[0] + x[1] + x[2]) / 3;
    for (int i = 0; i <= divisions; ++i)
        for (int j = 0; i + j <= divisions; ++j) {
            const Vec3 even = x[0] + (i * (x[1] - x[0]) + j * (x[2] - x[0])) / divisions;
            visit(even + just_inside * (centre - even));
        }
}

void addEvenly(const TriangleCorners& x, const Vec3& area, int divisions, SurfaceCloud& cloud) {
    forEvenPoints(x, divisions, [&](const Vec3& even) {
        cloud.points.push_back(even);
        cloud.areas.emplace_back(area / evenCount(divisions));
    });
}

/// Takes the points on large triangles together where there are many of them, as along a tube of many sides:
/// those of a cell whose surface faces alike.
class TakenTogether {
  public:
    explicit TakenTogether(const Eigen::AlignedBox3d& box)
        : low_(box.min()),
          cell_(box.sizes().maxCoeff() / cells_across),
          of_cell_(6 * cells * cells * cells, -1) {}

    void add(const TriangleCorners& x, const Vec3& area, int divisions, double spacing) {
        int axis;
        area.cwiseAbs().maxCoeff(&axis);
        const int side = 2 * axis + (area[axis] > 0);
        int shortest = 0;
        const auto square = [&](int edge) { return (x[(edge + 1) % 3] - x[edge]).squaredNorm(); };
        for (int edge = 1; edge < 3; ++edge)
            if (square(edge) < square(shortest)) shortest = edge;
        if (square(shortest) > spacing * spacing)
            return forEvenPoints(x, divisions,
                                 [&](const Vec3& even) { addTo(side, even, area / evenCount(divisions)); });
        // One strip of points along a sliver is enough.
        const Vec3 middle = (x[shortest] + x[(shortest + 1) % 3]) / 2, tip = x[(shortest + 2) % 3];
        for (int i = 0; i < divisions; ++i) {  // as much narrower as nearer to the tip
            const double from = double(i) / divisions, to = double(i + 1) / divisions;
            addTo(side, middle + (from + to) / 2 * (tip - middle), (to - from) * (2 - from - to) * area);
        }
    }
    void giveTo(SurfaceCloud& cloud) const {
        for (const Sum& sum : sums_) {
            cloud.points.emplace_back(sum.moment / sum.weight);
            cloud.areas.push_back(sum.area);
        }
    }

  private:
    static constexpr int cells = cells_across + 1;
    struct Sum {
        double weight = 0;
        Vec3 moment = Vec3::Zero(), area = Vec3::Zero();
    };

    void addTo(int side, const Vec3& point, const Vec3& area) {
        const double weight = area.norm();
        if (!(weight > 0)) return;
        const Eigen::Vector3i i = ((point - low_) / cell_).cast<int>();
        int& place = of_cell_[((side * cells + i.z()) * cells + i.y()) * cells + i.x()];
        if (place < 0) {
            place = static_cast<int>(sums_.size());
            sums_.emplace_back();
        }
        Sum& sum = sums_[place];
        sum.weight += weight;
        sum.moment += weight * point;
        sum.area += area;
    }

    Vec3 low_;
    double cell_;
    std::vector<int> of_cell_;  // by the side that the surface faces, too
    std::vector<Sum> sums_;
};

}  // namespace

SurfaceCloud cloudOf(const TriangleMesh& surface) {
    SurfaceCloud cloud;
    const Eigen::AlignedBox3d box = boundingBox(surface.vertices);
    cloud.spacing = box.diagonal().norm() / spacings_across;
    std::vector<int> divisions_of;
    std::size_t even_points = 0, on_slivers = 0;
    for (const auto& [a, b, c] : surface.triangles) {
        const Vec3 side = surface.vertices[b] - surface.vertices[a],
                   other = surface.vertices[c] - surface.vertices[a];
        const int divisions = divisionsOf(longestSquare(side, other), cloud.spacing);
        divisions_of.push_back(divisions);
        if (divisions == 1) continue;
        even_points += evenCount(divisions);
        if (shortestSquare(side, other) < cloud.spacing * cloud.spacing) on_slivers += evenCount(divisions);
    }
    std::optional<TakenTogether> together;
    if (even_points > most_even_points || on_slivers > most_on_slivers) together.emplace(box);
    Representatives points(surface, box, cloud);
    Steps steps(box);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const Vec3 side = surface.vertices[b] - surface.vertices[a],
                   other = surface.vertices[c] - surface.vertices[a], area = side.cross(other) / 2;
        if (liesAcrossAny(area)) steps.add(cornersOf(surface, t), area);
        const int divisions = divisions_of[t];
        if (divisions == 1)
            for (const int corner : surface.triangles[t]) cloud.areas[points.of(corner)] += area / 3;
        else if (together)
            together->add(cornersOf(surface, t), area, divisions, cloud.spacing);
        else
            addEvenly(cornersOf(surface, t), area, divisions, cloud);
    }
    if (together) together->giveTo(cloud);
    // So a plane in a face has the face on the side where the solid is.
    for (std::size_t p = 0; p < cloud.points.size(); ++p)
        cloud.points[p] -= just_inside * cloud.spacing * cloud.areas[p].normalized();
    cloud.steps = std::make_shared<const std::array<std::vector<SurfaceCloud::Step>, 3>>(
        std::array<std::vector<SurfaceCloud::Step>, 3>{steps.along(0), steps.along(1), steps.along(2)});
    return cloud;
}

}  // namespace sherd
