#include "geometry/convex/possible_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/numerics/mesh_measures.h"
#include "geometry/convex/oriented_polytope.h"

namespace sherd {

namespace {

constexpr int slices = 16;  // across the box, that may be parted from each other
constexpr int fewest_slices =
    3;  // of them on either side, but at steps: a greedy search takes slivers off a hollow

/// The planes between slices across an axis: at equal distances, each in the largest flat face across the
/// axis that is nearer to it than to the others.
class Planes {
  public:
    Planes(const std::vector<SurfaceCloud::Step>& steps, double low, double high)
        : low_(low), thickness_(std::max((high - low) / slices, 1e-30)) {
        for (int s = 0; s <= slices; ++s) offset_[s] = low + s * thickness_;
        std::array<double, slices + 1> area{};
        for (const SurfaceCloud::Step& step : steps) {
            const double place = (step.offset - low_) / thickness_;
            if (!(place > 0.5 && place < slices - 0.5)) continue;
            const int s = static_cast<int>(std::lround(place));
            if (step.area <= area[s]) continue;
            area[s] = step.area;
            offset_[s] = step.offset;
        }
        for (int s = 1; s < slices; ++s)
            allowed_[s] = area[s] > 0 || (s >= fewest_slices && s <= slices - fewest_slices);
    }
    int sliceOf(double x) const {
        int s = std::clamp(static_cast<int>((x - low_) / thickness_), 0, slices - 1);
        while (s > 0 && x < offset_[s]) --s;
        while (s < slices - 1 && x >= offset_[s + 1]) ++s;
        return s;
    }
    /// Below slice s.
    double offset(int s) const { return offset_[s]; }
    bool isAllowed(int s) const { return allowed_[s]; }

  private:
    double low_, thickness_;
    std::array<double, slices + 1> offset_{};
    std::array<bool, slices + 1> allowed_{};
};

using Slices = std::array<OrientedPolytope, slices>;

double priceOfPart(const OrientedPolytope& part) {
    return priceOf(part.volume(), part.diagonal());
}

struct Estimate {
    int slice = 0;  // before which the cut is; 0: all points are in one slice
    double price = std::numeric_limits<double>::infinity();
};

/// The cut that leaves the smallest hulls.
Estimate bestSlice(const Slices& of_slice, int axis, const Planes& planes) {
    std::array<OrientedPolytope, slices + 1> before, behind;
    for (int s = 0; s < slices; ++s) {
        before[s + 1] = before[s];
        before[s + 1].add(of_slice[s]);
        behind[slices - 1 - s] = behind[slices - s];
        behind[slices - 1 - s].add(of_slice[slices - 1 - s]);
    }
    Estimate best;
    for (int s = 1; s < slices; ++s) {
        if (!planes.isAllowed(s) || before[s].empty() || behind[s].empty()) continue;
        before[s].high[axis] = behind[s].low[axis] = planes.offset(s);  // where the sections will be
        const double price = priceOfPart(before[s]) + priceOfPart(behind[s]);
        if (price < best.price) best = {s, price};
    }
    return best;
}

}  // namespace

double priceOf(double hull_volume, double length) {
    return hull_volume * std::sqrt(length);
}

std::vector<AxisPlane> possibleCuts(const SurfaceCloud& cloud) {
    const Eigen::AlignedBox3d box = boundingBox(cloud.points);
    std::vector<OrientedPolytope::Reach> reach;
    reach.reserve(cloud.points.size());
    for (const Vec3& x : cloud.points) reach.push_back(OrientedPolytope::reachOf(x));
    std::vector<std::pair<double, AxisPlane>> cuts;
    for (int axis = 0; axis < 3; ++axis) {
        const Planes planes((*cloud.steps)[axis], box.min()[axis], box.max()[axis]);
        Slices along;
        for (std::size_t p = 0; p < cloud.points.size(); ++p)
            along[planes.sliceOf(cloud.points[p][axis])].add(reach[p]);
        const Estimate best = bestSlice(along, axis, planes);
        if (best.slice > 0) cuts.push_back({best.price, {axis, planes.offset(best.slice)}});
    }
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<AxisPlane> planes;
    for (const auto& [price, plane] : cuts) planes.push_back(plane);
    return planes;
}

}  // namespace sherd
