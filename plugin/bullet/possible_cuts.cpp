#include "bullet/possible_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bullet/oriented_polytope.h"
#include "core/numerics/mesh_measures.h"

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

/// The slice before which a cut leaves the smallest hulls; 0 if all points are in one slice.
int bestSlice(const Slices& of_slice, int axis, const Planes& planes) {
    std::array<OrientedPolytope, slices + 1> before, behind;
    for (int s = 0; s < slices; ++s) {
        before[s + 1] = before[s];
        before[s + 1].add(of_slice[s]);
        behind[slices - 1 - s] = behind[slices - s];
        behind[slices - 1 - s].add(of_slice[slices - 1 - s]);
    }
    double least = std::numeric_limits<double>::infinity();
    int best = 0;
    for (int s = 1; s < slices; ++s) {
        if (!planes.isAllowed(s) || before[s].empty() || behind[s].empty()) continue;
        before[s].high[axis] = behind[s].low[axis] = planes.offset(s);  // where the sections will be
        const double price = priceOfPart(before[s]) + priceOfPart(behind[s]);
        if (price >= least) continue;
        least = price;
        best = s;
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
    for (const Vec3& x : cloud.points) reach.push_back(OrientedPolytope::reachOf(x));
    std::vector<AxisPlane> cuts;
    for (int axis = 0; axis < 3; ++axis) {
        const Planes planes(cloud.steps[axis], box.min()[axis], box.max()[axis]);
        Slices along;
        for (std::size_t p = 0; p < cloud.points.size(); ++p)
            along[planes.sliceOf(cloud.points[p][axis])].add(reach[p]);
        if (const int slice = bestSlice(along, axis, planes)) cuts.push_back({axis, planes.offset(slice)});
    }
    return cuts;
}

}  // namespace sherd
