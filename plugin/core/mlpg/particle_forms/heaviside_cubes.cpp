#include <algorithm>
#include <array>
#include <cmath>

#include "core/mlpg/particle_forms/heaviside_blocks.h"
#include "core/numerics/gauss_legendre.h"

namespace sherd {
namespace {

constexpr int points_per_edge = 4;  // 4 x 4 on 6 faces: the paper's 96 points a particle

/// The sub-domain beyond a face of a cube.
struct FaceNeighbour {
    int particle = -1;  // none: a free boundary
    double area = 0;    // largest face of the solid that leads there
};
using CubeFaces = std::array<FaceNeighbour, 6>;  // face 2 axis + 1 is the upper one of an axis

/// The cubes of the particles, one for each cell of their grid, in units of their edges.
struct CubeGrid {
    Vec3 origin, edges;

    explicit CubeGrid(const Discretisation& solid)
        : origin(solid.grid_origin),
          edges(std::round(solid.particles.front().spacing / solid.cell_size.maxCoeff()) * solid.cell_size) {}

    Vec3 toGrid(const Vec3& x) const { return (x - origin).cwiseQuotient(edges); }
    Vec3 toWorld(const Vec3& u) const { return origin + u.cwiseProduct(edges); }
    /// Lower corner of the cube that a particle lies in.
    Vec3 cubeOf(const Particle& particle) const { return toGrid(particle.position).array().floor(); }
};

/// The face of a cube that a piece of a sub-domain's boundary lies in, or -1: merged sub-domains reach
/// beyond.
int faceOfCube(const Vec3& cube, const Vec3& point, const Vec3& outward) {
    constexpr double rounding = 1e-6;  // of an edge
    int axis;
    outward.cwiseAbs().maxCoeff(&axis);
    const int upper = outward[axis] > 0;
    const Eigen::Array3d offset = point - cube;
    const bool inside = (offset > -rounding).all() && (offset < 1 + rounding).all();
    return inside && std::abs(offset[axis] - upper) < rounding ? 2 * axis + upper : -1;
}

/// Per particle, what lies beyond the faces of its cube: the sub-domain that the largest face of the solid
/// leads to.
std::vector<CubeFaces> findNeighbours(const Discretisation& solid, const CubeGrid& grid) {
    std::vector<CubeFaces> faces(solid.particles.size());
    const auto link = [&](int particle, int other, const IntegrationFace& shared, const Vec3& outward) {
        const int side =
            faceOfCube(grid.cubeOf(solid.particles[particle]), grid.toGrid(shared.centroid), outward);
        if (side < 0 || faces[particle][side].area >= outward.norm()) return;
        faces[particle][side] = {other, outward.norm()};
    };
    for (const IntegrationFace& face : solid.faces) {
        const int from = solid.cells[face.cells[0]].particle, to = solid.cells[face.cells[1]].particle;
        if (from == to) continue;
        link(from, to, face, face.area);
        link(to, from, face, -face.area);
    }
    return faces;
}

struct GaussPoint {
    Vec3 position;  // m
    Vec3 area;      // weight, times the outward normal, m^2
};
using FacePoints = std::array<GaussPoint, points_per_edge * points_per_edge>;

FacePoints gaussPointsOn(int side, const Vec3& cube, const CubeGrid& grid, const GaussRule& rule) {
    const int axis = side / 2, upper = side % 2, e = (axis + 1) % 3, f = (axis + 2) % 3;
    FacePoints points;
    for (int i = 0; i < points_per_edge; ++i)
        for (int j = 0; j < points_per_edge; ++j) {
            Vec3 u = cube;
            u[axis] += upper;
            u[e] += 0.5 + rule.points[i];
            u[f] += 0.5 + rule.points[j];
            const double weight = rule.weights[i] * rule.weights[j] * grid.edges[e] * grid.edges[f];
            points[i * points_per_edge + j] = {grid.toWorld(u),
                                               (upper ? weight : -weight) * Vec3::Unit(axis)};
        }
    return points;
}

/// Sums the blocks of one sub-domain at a time.
class RowSum {
  public:
    explicit RowSum(size_t particles) : place_(particles, -1) {}

    void add(int particle, const Mat3& block) {
        int& place = place_[particle];
        if (place < 0) {
            place = static_cast<int>(row_.size());
            row_.emplace_back(particle, Mat3::Zero());
        }
        row_[place].second += block;
    }

    std::vector<std::pair<int, Mat3>> take() {
        for (const auto& entry : row_) place_[entry.first] = -1;
        std::sort(row_.begin(), row_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        return std::exchange(row_, {});
    }

  private:
    std::vector<int> place_;  // of a particle in the row, or -1
    std::vector<std::pair<int, Mat3>> row_;
};

}  // namespace

HeavisideBlocks fluxThroughCubes(const StressProblem& problem) {
    const Discretisation& solid = problem.solid;
    const CubeGrid grid(solid);
    const std::vector<CubeFaces> faces = findNeighbours(solid, grid);
    const GaussRule rule = gaussLegendre(points_per_edge);
    ShapeEvaluator evaluator(solid, problem.supports, problem.space);
    ShapeFunctions shapes;
    RowSum row(solid.particles.size());
    HeavisideBlocks blocks;
    for (int particle = 0; particle < static_cast<int>(solid.particles.size()); ++particle) {
        row.add(particle, Mat3::Zero());
        for (int side = 0; side < 6; ++side) {
            const int other = faces[particle][side].particle;
            if (other < 0) continue;
            for (const GaussPoint& point :
                 gaussPointsOn(side, grid.cubeOf(solid.particles[particle]), grid, rule)) {
                const Evaluation state =
                    evaluator.evaluateBetween(point.position, particle, other, true, shapes);
                ++blocks.evaluations[static_cast<size_t>(state)];
                for (size_t n = 0; n < shapes.particles.size(); ++n)
                    row.add(shapes.particles[n],
                            -fluxBlock(shapes.gradients[n], point.area, problem.elasticity));
            }
        }
        blocks.rows.push_back(row.take());
    }
    return blocks;
}

}  // namespace sherd
