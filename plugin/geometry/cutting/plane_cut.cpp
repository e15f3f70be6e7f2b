#include "geometry/cutting/plane_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sherd {

namespace {

constexpr double reach_in_spacings = 0.05;

}  // namespace

PlaneCutter::PlaneCutter(const CuttableSurface& surface, double particle_spacing_m, CutComplex& complex)
    : surface_(surface), reach_m_(reach_in_spacings * particle_spacing_m), complex_(complex) {}

PlaneCut PlaneCutter::cut(const PartBoundary& boundary, const CrackPlane& plane) {
    PlaneCut cut;
    ++number_;
    whole_.clear();
    cut_edges_.clear();
    takeBlocks(boundary.blocks, plane, cut);
    for (const FaceSide& at : boundary.faces) complex_.appendWhole(at, whole_);
    measure(plane);
    for (const FaceSide& at : whole_) {
        const auto& [a, b, c] = complex_.faces()[at.face].corners;
        const int above = (distance_[a] > 0) + (distance_[b] > 0) + (distance_[c] > 0);
        if (above == 0 || above == 3)
            cut.sides[above == 3].faces.push_back(at);
        else
            splitFace(at, cut);
    }
    return cut;
}

/// Blocks that the plane does not come near to stay what they are.
void PlaneCutter::takeBlocks(const std::vector<int>& blocks, const CrackPlane& plane, PlaneCut& cut) {
    const Vec3 facing = plane.normal.cwiseAbs();
    for (const int block : blocks) {
        const Eigen::AlignedBox3d& box = surface_.blockBoxes()[block];
        const double middle = plane.distance(box.center());
        if (std::abs(middle) > 0.5 * facing.dot(box.sizes()) + reach_m_) {
            cut.sides[middle > 0].blocks.push_back(block);
            continue;
        }
        surface_.forEachIn(block, [&](int triangle) { whole_.push_back({triangle, 0}); });
    }
}

/// The distances of the corners from the plane, which is moved so that none is very near to it.
void PlaneCutter::measure(const CrackPlane& plane) {
    const std::size_t count = complex_.points().size();
    distance_.resize(count, 0);
    seen_in_.resize(count, -1);
    first_cut_.resize(count, -1);
    corners_.clear();
    near_.clear();
    for (const FaceSide& at : whole_)
        for (const int v : complex_.faces()[at.face].corners) {
            if (std::exchange(seen_in_[v], number_) == number_) continue;
            corners_.push_back(v);
            first_cut_[v] = -1;
            distance_[v] = plane.distance(complex_.points()[v]);
            if (std::abs(distance_[v]) < reach_m_) near_.push_back(distance_[v]);
        }
    const double shift = clearPlace();
    for (const int v : corners_) distance_[v] -= shift;
}

/// Where among the corners near the plane there is room for it, the nearest such place.
double PlaneCutter::clearPlace() {
    near_.push_back(-reach_m_);
    near_.push_back(reach_m_);
    std::sort(near_.begin(), near_.end());
    // One of the gaps is that wide at least.
    const double wanted = 2 * reach_m_ / static_cast<double>(near_.size() - 1) * (1 - 1e-9);
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < near_.size(); ++k) {
        if (near_[k] - near_[k - 1] < wanted) continue;
        const double place = std::max(near_[k - 1] + wanted / 2, std::min(0.0, near_[k] - wanted / 2));
        if (std::abs(place) < std::abs(best)) best = place;
    }
    return best;
}

/// One corner is alone on its side; what lies on the other side becomes two triangles.
void PlaneCutter::splitFace(const FaceSide& at, PlaneCut& cut) {
    const Triangle corners = complex_.faces()[at.face].corners;
    const auto is_above = [&](int i) { return distance_[corners[i % 3]] > 0; };
    int alone = 0;
    while (is_above(alone) == is_above(alone + 1) || is_above(alone) == is_above(alone + 2)) ++alone;
    const int a = corners[alone], b = corners[(alone + 1) % 3], c = corners[(alone + 2) % 3];
    const int on_ab = cutEdge(a, b), on_ac = cutEdge(a, c);
    const std::vector<Vec3>& x = complex_.points();
    if ((x[b] - x[on_ac]).squaredNorm() < (x[c] - x[on_ab]).squaredNorm())
        complex_.split(at.face, {{a, on_ab, on_ac}, {on_ab, b, on_ac}, {b, c, on_ac}});
    else
        complex_.split(at.face, {{a, on_ab, on_ac}, {on_ab, b, c}, {on_ab, c, on_ac}});
    const bool alone_above = is_above(alone);
    const int first = complex_.faces()[at.face].first_child;
    cut.sides[alone_above].faces.push_back({first, at.side});
    cut.sides[!alone_above].faces.push_back({first + 1, at.side});
    cut.sides[!alone_above].faces.push_back({first + 2, at.side});
    // The crack face runs against the faces of the lower side, which turn outward seen from below.
    const bool is_outward = at.side == 0;
    if (is_outward == alone_above)
        cut.outlines.emplace_back(on_ab, on_ac);
    else
        cut.outlines.emplace_back(on_ac, on_ab);
}

/// The point where the plane crosses an edge, the same for all faces along it.
int PlaneCutter::cutEdge(int a, int b) {
    if (a > b) std::swap(a, b);
    for (int e = first_cut_[a]; e >= 0; e = cut_edges_[e].next)
        if (cut_edges_[e].other == b) return cut_edges_[e].point;
    const double t = distance_[a] / (distance_[a] - distance_[b]);
    const Vec3 from = complex_.points()[a], to = complex_.points()[b];
    const int point = complex_.addPointOnEdge(a, b, from + t * (to - from));
    cut_edges_.push_back({b, point, first_cut_[a]});
    first_cut_[a] = static_cast<int>(cut_edges_.size()) - 1;
    return point;
}

}  // namespace sherd
