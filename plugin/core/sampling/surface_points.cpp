#include "core/sampling/surface_points.h"

#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

constexpr double same_plane = 1 - 1e-10;  // cosine between normals of what counts as one plane
constexpr double same_side = 0.7;         // cosine between normals of what counts as one side of the solid
constexpr int most_planes = 3;            // a corner; with more, sides are curved
constexpr double rounding = 1e-13;        // of area times length

/// Pieces of one side of the solid in one cell.
struct Side {
    Vec3 normal;
    std::vector<SurfacePiece> pieces;
};

/// Groups pieces whose normals lie near that of a group's first piece. Empty when there would be more than
/// `most` groups.
std::vector<Side> groupByNormal(const std::vector<SurfacePiece>& pieces, double cosine, std::size_t most) {
    std::vector<Side> sides;
    for (const SurfacePiece& piece : pieces) {
        const double size = piece.area.norm();
        if (size == 0) continue;
        const auto side = std::find_if(sides.begin(), sides.end(), [&](const Side& s) {
            return s.normal.dot(piece.area) >= cosine * size;
        });
        if (side != sides.end()) {
            side->pieces.push_back(piece);
        } else {
            if (sides.size() == most) return {};
            sides.push_back({piece.area / size, {piece}});
        }
    }
    return sides;
}

/// The integral of f n over a side is f(c) A + D grad f, A the area vector and D = sum (x - c) area^T. Each
/// singular vector of D that counts becomes a point beside c, so that no more points are made than the side
/// is curved.
void addPoints(const Side& side, int cell, std::vector<SurfacePoint>& points) {
    Vec3 centroid = Vec3::Zero(), area = Vec3::Zero();
    double size = 0;
    for (const SurfacePiece& piece : side.pieces) {
        const double s = piece.area.norm();
        centroid += s * piece.centroid;
        area += piece.area;
        size += s;
    }
    centroid /= size;
    Mat3 deviation = Mat3::Zero(), spread = Mat3::Zero();
    for (const SurfacePiece& piece : side.pieces) {
        const Vec3 x = piece.centroid - centroid;
        deviation += x * piece.area.transpose();
        spread += piece.area.norm() / size * x * x.transpose();
    }
    const std::size_t main_point = points.size();
    points.push_back({cell, centroid, area});
    if (side.pieces.size() == 1) return;

    const Eigen::JacobiSVD<Mat3> svd(deviation, Eigen::ComputeFullU | Eigen::ComputeFullV);
    for (int k = 0; k < 3; ++k) {
        if (svd.singularValues()[k] <= rounding * size * std::sqrt(spread.trace() + size)) break;
        Vec3 direction = svd.matrixU().col(k);
        const double distance = std::sqrt(2 * direction.dot(spread * direction));
        Vec3 weight = svd.singularValues()[k] / distance * svd.matrixV().col(k);
        if (direction.dot(area) > 0) {  // rather into the solid than out of it
            direction = -direction;
            weight = -weight;
        }
        points.push_back({cell, centroid + distance * direction, weight});
        points[main_point].area -= weight;
    }
}

/// Pieces of each cell in metres, cell by cell: `first[c]` to `first[c + 1]`.
void sortByCell(const SamplingGrid& grid, const CutSurface& surface, const SolidVoxels& solid,
                const CutCells& cells, std::vector<SurfacePiece>& sorted, std::vector<int>& first) {
    const auto cellOf = [&](const SurfacePiece& piece) {
        return cells.of_voxel[std::size_t(solid.of_cut_voxel[std::size_t(piece.cut_voxel)])];
    };
    first.assign(cells.moments.size() + 1, 0);
    for (const SurfacePiece& piece : surface.pieces)
        if (cellOf(piece) >= 0) ++first[std::size_t(cellOf(piece)) + 1];
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    std::vector<int> next(first.begin(), first.end() - 1);
    sorted.resize(std::size_t(first.back()));
    const Vec3& edge = grid.cell_size;
    for (const SurfacePiece& piece : surface.pieces) {
        if (cellOf(piece) < 0) continue;
        SurfacePiece& target = sorted[std::size_t(next[std::size_t(cellOf(piece))]++)];
        const Vec3 voxel = grid.voxelAt(surface.voxels[std::size_t(piece.cut_voxel)]).cast<double>();
        target = piece;
        target.area = edge.prod() * piece.area.cwiseQuotient(edge);
        target.centroid = grid.toWorld(voxel + Vec3::Constant(0.5) + piece.centroid);
    }
}

}  // namespace

std::vector<SurfacePoint> surfacePoints(const SamplingGrid& grid, const CutSurface& surface,
                                        const SolidVoxels& solid, const CutCells& cells) {
    std::vector<SurfacePiece> sorted, pieces;
    std::vector<int> first;
    sortByCell(grid, surface, solid, cells, sorted, first);
    std::vector<SurfacePoint> points;
    for (std::size_t c = 0; c < cells.moments.size(); ++c) {
        pieces.assign(sorted.begin() + first[c], sorted.begin() + first[c + 1]);
        std::vector<Side> sides = groupByNormal(pieces, same_plane, most_planes);
        if (sides.empty()) sides = groupByNormal(pieces, same_side, pieces.size());
        for (const Side& side : sides) addPoints(side, int(c), points);
    }
    return points;
}

}  // namespace sherd
