#include "core/sampling/solid_voxels.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sherd {
namespace {

constexpr int empty_voxel = -1, full_voxel = -2;
// Of a voxel face: the error of the flux by rounding is far smaller, by a missing triangle far larger.
constexpr double closing_tolerance = 1e-6;
constexpr double smallest_face = 1e-13;  // of a voxel face; less is rounding

using FaceMoments = std::array<double, 6>;  // 1, u, v, uu, uv, vv
constexpr FaceMoments full_face = {1, 0, 0, 1.0 / 12, 0, 1.0 / 12};

void add(FaceMoments& sum, const FaceMoments& terms) {
    for (int i = 0; i < 6; ++i) sum[i] += terms[i];
}

RawMoments fullVoxel() {
    RawMoments moments;
    moments.volume = 1;
    moments.second = Mat3::Identity() / 12;
    return moments;
}

/// Divergence theorem with the flux along x: f = div (F, 0, 0) with F the integral of f over x.
RawMoments cutVoxel(const FaceMoments& lower, const FaceMoments& upper,
                    const std::array<double, 10>& surface) {
    const auto even = [&](int i) { return (upper[i] + lower[i]) / 2; };  // F = x g at x = +-1/2
    const auto odd = [&](int i) { return (upper[i] - lower[i]) / 8; };   // F = x^2 g / 2
    RawMoments m;
    m.volume = even(0) + surface[0];
    m.first = {odd(0) + surface[1], even(1) + surface[2], even(2) + surface[3]};
    const double xx = (upper[0] + lower[0]) / 24 + surface[4];
    const double xy = odd(1) + surface[5], xz = odd(2) + surface[6];
    const double yy = even(3) + surface[7], yz = even(4) + surface[8], zz = even(5) + surface[9];
    m.second << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
}

/// One row of voxels along an axis, walked from the top down.
struct Row {
    long long first = 0, stride = 1;
    int count = 0;
    long long at(int i) const { return first + i * stride; }
};

template <class Visit>
Status forEachRow(const SamplingGrid& grid, int axis, Visit&& visit) {
    const int e = (axis + 1) % 3, f = (axis + 2) % 3;
    const std::array<long long, 3> stride = {1, grid.count.x(), 1LL * grid.count.x() * grid.count.y()};
    for (int j = 0; j < grid.count[f]; ++j)
        for (int i = 0; i < grid.count[e]; ++i) {
            const Status status = visit(Row{i * stride[e] + j * stride[f], stride[axis], grid.count[axis]});
            if (!status) return status;
        }
    return success();
}

/// The sentence for a voxel that no triangle cuts and whose flux says that it is neither full nor empty.
/// `layers`: how many times the solid would fill it.
Error notClosed(const SamplingGrid& grid, long long voxel, double layers) {
    const Vec3 x = grid.toWorld(grid.voxelAt(voxel).cast<double>() + Vec3::Constant(0.5));
    std::ostringstream text;
    text.precision(4);
    const bool whole = std::abs(layers - std::round(layers)) < closing_tolerance;
    if (whole && layers < 0)
        text << "The surface is inside out";
    else if (whole && layers > 1.5)
        text << "Parts of the solid overlap";
    else
        text << "The surface is not closed";
    text << " near (" << x.x() << ", " << x.y() << ", " << x.z() << ") m; ";
    text << (whole && layers < 0 ? "flip the triangles so that they are counter-clockwise seen from outside."
             : whole && layers > 1.5 ? "unite them into one surface first."
                                     : "close its holes and orient all triangles outward.");
    return {text.str()};
}

/// Walks the rows along x: measures every cut voxel, and sets the state of the others to full or empty.
Result<std::vector<RawMoments>> measureVoxels(const SamplingGrid& grid, const CutSurface& surface,
                                              std::vector<int>& state) {
    std::vector<RawMoments> moments(surface.voxels.size());
    const Status status = forEachRow(grid, 0, [&](const Row& row) -> Status {
        FaceMoments upper{};
        for (int i = row.count - 1; i >= 0; --i) {
            int& voxel = state[std::size_t(row.at(i))];
            if (voxel >= 0) {
                const SurfaceFlux& flux = surface.flux[std::size_t(voxel)];
                FaceMoments lower = upper;
                add(lower, flux.face[0]);
                moments[std::size_t(voxel)] = cutVoxel(lower, upper, flux.volume);
                upper = lower;
                continue;
            }
            const double filled = std::round(upper[0]);
            if (std::abs(upper[0] - filled) > closing_tolerance || filled < 0 || filled > 1)
                return notClosed(grid, row.at(i), upper[0]);
            // No triangle comes near: the exact values, so that rounding does not travel along the row.
            voxel = filled == 1 ? full_voxel : empty_voxel;
            upper = filled == 1 ? full_face : FaceMoments{};
        }
        return std::abs(upper[0]) > closing_tolerance ? Status(notClosed(grid, row.at(0), upper[0]))
                                                      : success();
    });
    if (!status) return Error{status.error()};
    return moments;
}

/// The solid part of the topmost face of a row that ends inside the solid: the one from which the flux leads
/// to the right value (full or empty) at the first uncut voxel; without such a voxel, an estimate by the fill
/// of the topmost one.
FaceMoments faceAboveRow(const Row& row, const CutSurface& surface, const std::vector<int>& state,
                         const std::vector<RawMoments>& fills, int axis) {
    FaceMoments flux{};
    for (int i = row.count - 1; i >= 0; --i) {
        const int voxel = state[std::size_t(row.at(i))];
        if (voxel >= 0) {
            add(flux, surface.flux[std::size_t(voxel)].face[std::size_t(axis)]);
            continue;
        }
        FaceMoments face = voxel == full_voxel ? full_face : FaceMoments{};
        for (int k = 0; k < 6; ++k) face[std::size_t(k)] -= flux[std::size_t(k)];
        return face;
    }
    const int top = state[std::size_t(row.at(row.count - 1))];
    FaceMoments face{};
    face[0] = std::min(1.0, std::max(0.0, fills[std::size_t(top)].volume));
    return face;
}

/// Walks the rows along an axis and measures the solid part of every face across it.
Status measureFaces(const SamplingGrid& grid, const CutSurface& surface, const std::vector<int>& state,
                    const std::vector<int>& number, const std::vector<RawMoments>& fills, int axis,
                    std::vector<VoxelFace>& faces) {
    const bool open = grid.window && axis > 0;  // rows may begin and end inside the solid
    return forEachRow(grid, axis, [&](const Row& row) -> Status {
        FaceMoments sum{};
        if (open) sum = faceAboveRow(row, surface, state, fills, axis);
        for (int i = row.count - 1; i >= 0; --i) {
            const std::size_t here = std::size_t(row.at(i));
            if (state[here] >= 0) {
                add(sum, surface.flux[std::size_t(state[here])].face[std::size_t(axis)]);
            } else {
                const double filled = state[here] == full_voxel ? 1 : 0;
                if (!open && std::abs(sum[0] - filled) > closing_tolerance)
                    return notClosed(grid, row.at(i), sum[0]);
                sum = filled == 1 ? full_face : FaceMoments{};
            }
            if (i == 0) break;
            const std::size_t below = std::size_t(row.at(i - 1));
            if (number[here] < 0 || number[below] < 0) continue;
            const FaceMoments& face = state[below] == full_voxel ? full_face : sum;
            if (face[0] < smallest_face) continue;
            const auto inside = [](double c) { return std::min(0.5, std::max(-0.5, c)); };
            faces.push_back({{number[below], number[here]},
                             axis,
                             face[0],
                             inside(face[1] / face[0]),
                             inside(face[2] / face[0])});
        }
        return !open && std::abs(sum[0]) > closing_tolerance ? Status(notClosed(grid, row.at(0), sum[0]))
                                                             : success();
    });
}

}  // namespace

RawMoments& RawMoments::operator+=(const RawMoments& other) {
    volume += other.volume;
    first += other.first;
    second += other.second;
    return *this;
}

RawMoments RawMoments::shifted(const Vec3& shift) const {
    RawMoments m = *this;
    m.first += volume * shift;
    m.second += first * shift.transpose() + shift * first.transpose() + volume * shift * shift.transpose();
    return m;
}

Result<SolidVoxels> fillVoxels(const SamplingGrid& grid, const CutSurface& surface) {
    std::vector<int> state = surface.cut_voxel_at;  // index of a cut voxel, or empty_voxel, or full_voxel
    const Result<std::vector<RawMoments>> cut_moments = measureVoxels(grid, surface, state);
    if (!cut_moments) return Error{cut_moments.error()};

    SolidVoxels solid;
    solid.of_cut_voxel.resize(surface.voxels.size());
    std::vector<int> number(state.size(), -1);
    const std::size_t count = state.size() - std::size_t(std::count(state.begin(), state.end(), empty_voxel));
    solid.index.reserve(count);
    solid.moments.reserve(count);
    solid.faces.reserve(3 * count);
    for (std::size_t v = 0; v < state.size(); ++v) {
        if (state[v] == empty_voxel) continue;
        number[v] = int(solid.index.size());
        solid.index.push_back((long long)v);
        solid.moments.push_back(state[v] == full_voxel ? fullVoxel()
                                                       : cut_moments.value()[std::size_t(state[v])]);
        if (state[v] >= 0) solid.of_cut_voxel[std::size_t(state[v])] = number[v];
    }
    for (int axis = 0; axis < 3; ++axis) {
        const Status status =
            measureFaces(grid, surface, state, number, cut_moments.value(), axis, solid.faces);
        if (!status) return Error{status.error()};
    }
    return solid;
}

}  // namespace sherd
