#include "core/sampling/box_fit.h"

#include <algorithm>
#include <cmath>

namespace sherd {

namespace {

using Index = Eigen::Vector3i;

constexpr double next_to_nothing = 0.01;  // of a layer; less is no layer of its own

template <class Visit>
void forVoxels(const VoxelIndex& index, const Index& low, const Index& high, const Visit& visit) {
    for (int z = low.z(); z <= high.z(); ++z)
        for (int y = low.y(); y <= high.y(); ++y)
            for (int x = low.x(); x <= high.x(); ++x)
                if (const int v = index.at({x, y, z}); v >= 0) visit(v);
}

double areaAcross(const Index& low, const Index& high, int axis) {
    const Index size = high - low + Index::Ones();
    return static_cast<double>(size.prod()) / size[axis];
}

}  // namespace

bool BoxFit::Profile::isOpen() const {
    const auto layers = fill.size() + (below > next_to_nothing) + (above > next_to_nothing);
    return layers == 1 ? free_below || free_above : layers == 2 && free_below && free_above;
}

double BoxFit::layerBeside(Index low, Index high, int axis, int layer, bool& free) const {
    const double area = areaAcross(low, high, axis);
    low[axis] = high[axis] = layer;
    double fill = 0;
    forVoxels(index_, low, high, [&](int v) {
        if (isCovered(v)) free = false;
        fill += solid_.voxels[v].fill;
    });
    // What another piece has nearby it may grow into as well: pieces must not overlap.
    const Index around = Index::Ones() - Index::Unit(axis);
    forVoxels(index_, low - around, high + around, [&](int v) {
        if (!isWanted(v)) free = false;
    });
    return free ? fill / area : 0;
}

BoxFit::Profile BoxFit::profileOf(const Index& low, const Index& high, int axis) const {
    Profile profile;
    const double area = areaAcross(low, high, axis);
    for (int layer = low[axis]; layer <= high[axis]; ++layer) {
        Index from = low, to = high;
        from[axis] = to[axis] = layer;
        double fill = 0;
        forVoxels(index_, from, to, [&](int v) { fill += solid_.voxels[v].fill; });
        profile.fill.push_back(fill / area);
    }
    profile.below = layerBeside(low, high, axis, low[axis] - 1, profile.free_below);
    profile.above = layerBeside(low, high, axis, high[axis] + 1, profile.free_above);
    // Other axes may leave all layers partly empty: they are compared with the fullest.
    const double fullest = *std::max_element(profile.fill.begin(), profile.fill.end());
    for (double& fill : profile.fill) fill /= fullest;
    profile.below = std::min(1.0, profile.below / fullest);
    profile.above = std::min(1.0, profile.above / fullest);
    return profile;
}

// A layer or two do not say how much of their fill is this axis's, but the moments of what is in them do: a
// slab of thickness t has the variance t^2 / 12.
BoxFit::Faces BoxFit::facesFromMoments(const Profile& profile, Index low, Index high, int axis) const {
    const int first = low[axis];
    low[axis] -= profile.below > 0;
    high[axis] += profile.above > 0;
    double weight = 0, mean = 0, square = 0;
    forVoxels(index_, low, high, [&](int v) {
        const Discretisation::Voxel& voxel = solid_.voxels[v];
        const Moments& moments = solid_.cells[voxel.cell].moments;
        const double cell = solid_.cell_size[axis];
        const double at = (moments.centroid[axis] - solid_.grid_origin[axis]) / cell - first;
        weight += voxel.fill;
        mean += voxel.fill * at;
        square += voxel.fill * (moments.second(axis, axis) / moments.volume / (cell * cell) + at * at);
    });
    mean /= weight;
    const double thickness = std::sqrt(12 * std::max(0.0, square / weight - mean * mean));
    if (!profile.free_below) return {0, std::min(1.0, thickness)};
    if (!profile.free_above) return {1 - std::min(1.0, thickness), 1};
    return {mean - thickness / 2, mean + thickness / 2};
}

BoxFit::Faces BoxFit::facesOf(const Profile& profile, const Index& low, const Index& high, int axis) const {
    if (profile.isOpen()) return facesFromMoments(profile, low, high, axis);
    const double layers = static_cast<double>(profile.fill.size());
    Faces faces{0, layers};
    if (profile.free_below) faces.lower = 1 - profile.fill.front() - profile.below;
    if (profile.free_above) faces.upper = layers - 1 + profile.fill.back() + profile.above;
    return faces;
}

Box BoxFit::fit(const Index& low, const Index& high) const {
    constexpr double as_large = 0.1;  // relative
    Index from = low, to = high;      // with the layers that the box may reach into
    Vec3 lower, upper;                // in voxels
    for (int axis = 0; axis < 3; ++axis) {
        const Profile profile = profileOf(low, high, axis);
        const Faces faces = facesOf(profile, low, high, axis);
        from[axis] -= profile.below > 0;
        to[axis] += profile.above > 0;
        lower[axis] = low[axis] + faces.lower;
        upper[axis] = low[axis] + faces.upper;
    }
    double volume = 0;
    forVoxels(index_, from, to, [&](int v) { volume += solid_.voxels[v].fill; });
    const bool is_box = std::abs((upper - lower).prod() / volume - 1) < as_large;
    if (!is_box) {  // the solid lies across the grid there
        lower = low.cast<double>();
        upper = (high + Index::Ones()).cast<double>();
    }
    lower = solid_.grid_origin + lower.cwiseProduct(solid_.cell_size);
    upper = solid_.grid_origin + upper.cwiseProduct(solid_.cell_size);
    return {0.5 * (lower + upper), 0.5 * (upper - lower)};
}

}  // namespace sherd
