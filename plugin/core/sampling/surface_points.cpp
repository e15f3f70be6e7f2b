#include "core/sampling/surface_points.h"

#include <cmath>

namespace sherd {
namespace {

constexpr double same_plane = 1 - 1e-10;  // cosine between normals of what counts as one plane
constexpr double same_side = 0.7;         // cosine between normals of what counts as one side of the solid
constexpr double nearly_flat = 0.99;      // |sum of area vectors| / area from which a side has one normal
constexpr std::size_t most_planes = 3;    // as at a corner; with more the surface counts as curved
constexpr double no_area = 1e-40;         // square of an area, of a voxel face: too small for a direction
constexpr double rounding = 1e-13;        // of area times length

/// The part of one triangle inside one cell, m.
struct Facet {
    Vec3 area;  ///< area times the outward unit normal
    Vec3 centroid;
    double size = 0;
    int side = -1;
};

using Facets = std::vector<Facet>;

/// Groups facets into sides: each joins the first side whose first facet has a normal near its own. False if
/// that would take more than `most` sides.
bool groupByNormal(Facets::iterator first, Facets::iterator last, double cosine, std::size_t most,
                   std::vector<Vec3>& normals) {
    normals.clear();
    for (auto facet = first; facet != last; ++facet) {
        std::size_t side = 0;
        while (side < normals.size() && normals[side].dot(facet->area) < cosine * facet->size) ++side;
        facet->side = int(side);
        if (side < normals.size()) continue;
        if (side == most) return false;
        normals.push_back(facet->area / facet->size);
    }
    return true;
}

/// Points that add D = sum (x - c) area^T to the rule of one point at c: D is split into a sum of d_k w_k^T
/// with orthogonal unit vectors d_k, and each term becomes a point at distance h from c along d_k with the
/// weight w_k / h, taken off the weight at c. With h the spread of the facets no weight exceeds their area.
void addDeviation(Mat3 deviation, const Mat3& spread, double tolerance, std::size_t centre,
                  std::vector<SurfacePoint>& points) {
    const Vec3 outward = points[centre].area;
    for (int k = 0; k < 3; ++k) {
        int column = 0;
        const double length = std::sqrt(deviation.colwise().squaredNorm().maxCoeff(&column));
        if (length <= tolerance) break;
        Vec3 direction = deviation.col(column) / length;
        if (direction.dot(outward) > 0) direction = -direction;  // rather into the solid than out of it
        const double squared = 2 * direction.dot(spread * direction);
        if (!(squared > rounding * spread.trace())) break;  // no facet is off the centroid that way
        const double distance = std::sqrt(squared);
        const Vec3 weight = deviation.transpose() * direction;
        deviation -= direction * weight.transpose();
        points.push_back({points[centre].cell, points[centre].position + distance * direction,
                          weight / distance, Vec3::Zero()});
        points[centre].area -= weight / distance;
    }
}

/// The points of one side. For linear f the integral of f n over it is f(c) A + D^T grad f, with A its area
/// vector and c its centroid; D = 0 if it is flat.
void addPoints(Facets::const_iterator first, Facets::const_iterator last, int side, int cell,
               std::vector<SurfacePoint>& points) {
    Vec3 centroid = Vec3::Zero(), area = Vec3::Zero();
    double size = 0;
    int count = 0;
    for (auto facet = first; facet != last; ++facet) {
        if (facet->side != side) continue;
        centroid += facet->size * facet->centroid;
        area += facet->area;
        size += facet->size;
        ++count;
    }
    centroid /= size;
    points.push_back(
        {cell, centroid, area, area.norm() > nearly_flat * size ? area.normalized() : Vec3::Zero()});
    if (count == 1) return;

    Mat3 deviation = Mat3::Zero(), spread = Mat3::Zero();
    for (auto facet = first; facet != last; ++facet) {
        if (facet->side != side) continue;
        const Vec3 x = facet->centroid - centroid;
        deviation += x * facet->area.transpose();
        spread += facet->size / size * x * x.transpose();
    }
    const double tolerance = rounding * size * std::sqrt(spread.trace() + size);
    addDeviation(deviation, spread, tolerance, points.size() - 1, points);
}

/// The facets sorted by cell: those of cell c are numbers first[c] to first[c + 1] - 1.
Facets facetsByCell(const SamplingGrid& grid, const CutSurface& surface, const SolidVoxels& solid,
                    const CutCells& cells, std::vector<int>& first) {
    const auto cellOf = [&](const SurfacePiece& piece) {
        if (piece.area.squaredNorm() < no_area) return -1;
        return cells.of_voxel[std::size_t(solid.of_cut_voxel[std::size_t(piece.cut_voxel)])];
    };
    first.assign(cells.moments.size() + 1, 0);
    for (const SurfacePiece& piece : surface.pieces)
        if (const int cell = cellOf(piece); cell >= 0) ++first[std::size_t(cell) + 1];
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    std::vector<int> next(first.begin(), first.end() - 1);
    Facets facets(std::size_t(first.back()));
    const Vec3 cofactor = Vec3::Constant(grid.voxelVolume()).cwiseQuotient(grid.cell_size);
    for (const SurfacePiece& piece : surface.pieces) {
        const int cell = cellOf(piece);
        if (cell < 0) continue;
        Facet& facet = facets[std::size_t(next[std::size_t(cell)]++)];
        const Vec3 voxel = grid.voxelAt(surface.voxels[std::size_t(piece.cut_voxel)]).cast<double>();
        facet.area = piece.area.cwiseProduct(cofactor);
        facet.centroid = grid.toWorld(voxel + Vec3::Constant(0.5) + piece.centroid);
        facet.size = facet.area.norm();
    }
    return facets;
}

}  // namespace

std::vector<SurfacePoint> surfacePoints(const SamplingGrid& grid, const CutSurface& surface,
                                        const SolidVoxels& solid, const CutCells& cells) {
    std::vector<int> first;
    Facets facets = facetsByCell(grid, surface, solid, cells, first);
    std::vector<SurfacePoint> points;
    std::vector<Vec3> normals;
    for (std::size_t c = 0; c < cells.moments.size(); ++c) {
        const auto begin = facets.begin() + first[c], end = facets.begin() + first[c + 1];
        if (!groupByNormal(begin, end, same_plane, most_planes, normals))
            groupByNormal(begin, end, same_side, facets.size(), normals);
        for (std::size_t side = 0; side < normals.size(); ++side)
            addPoints(begin, end, int(side), int(c), points);
    }
    points.shrink_to_fit();  // kept with the body
    return points;
}

}  // namespace sherd
