#include "core/mlpg/particle_forms/cell_gradients.h"

#include <utility>

#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int chunk_count = 32;

/// Values of the shape functions at a range of points, one after the other.
struct ShapeTable {
    int first_point = 0;
    std::vector<int> starts{0};
    std::vector<int> particles;
    std::vector<double> values;
    EvaluationCounts evaluations{};
};

/// Quadrature points in one numbering: faces first, then surface points.
struct QuadraturePoints {
    const Discretisation& solid;

    int count() const { return static_cast<int>(solid.faces.size() + solid.surface_points.size()); }

    Evaluation evaluate(int point, ShapeEvaluator& evaluator, ShapeFunctions& shapes) const {
        const int faces = static_cast<int>(solid.faces.size());
        if (point >= faces) {
            const SurfacePoint& surface = solid.surface_points[point - faces];
            return evaluator.evaluate(surface.position, solid.cells[surface.cell].particle, false, shapes);
        }
        const IntegrationFace& face = solid.faces[point];
        return evaluator.evaluateBetween(face.centroid, solid.cells[face.cells[0]].particle,
                                         solid.cells[face.cells[1]].particle, false, shapes);
    }
};

std::vector<ShapeTable> evaluateShapes(const QuadraturePoints& points, const SupportGraph& supports,
                                       const TrialSpace& space) {
    std::vector<ShapeTable> tables(chunk_count);
    forEachChunk(chunk_count, [&](int chunk) {
        ShapeTable& table = tables[chunk];
        ShapeEvaluator evaluator(points.solid, supports, space);
        ShapeFunctions shapes;
        table.first_point = chunkBegin(chunk, chunk_count, points.count());
        const int end = chunkBegin(chunk + 1, chunk_count, points.count());
        for (int point = table.first_point; point < end; ++point) {
            const Evaluation state = points.evaluate(point, evaluator, shapes);
            ++table.evaluations[static_cast<size_t>(state)];
            table.particles.insert(table.particles.end(), shapes.particles.begin(), shapes.particles.end());
            table.values.insert(table.values.end(), shapes.values.begin(), shapes.values.end());
            table.starts.push_back(static_cast<int>(table.particles.size()));
        }
    });
    return tables;
}

/// For every cell the quadrature points that bound it, with the sign of their area vector seen from the cell.
struct CellBoundaries {
    std::vector<int> starts;
    std::vector<std::pair<int, double>> points;
};

CellBoundaries cellBoundaries(const Discretisation& solid) {
    CellBoundaries boundaries;
    boundaries.starts.assign(solid.cells.size() + 1, 0);
    for (const IntegrationFace& face : solid.faces)
        for (int cell : face.cells) ++boundaries.starts[cell + 1];
    for (const SurfacePoint& point : solid.surface_points) ++boundaries.starts[point.cell + 1];
    for (size_t cell = 0; cell < solid.cells.size(); ++cell)
        boundaries.starts[cell + 1] += boundaries.starts[cell];

    boundaries.points.resize(boundaries.starts.back());
    std::vector<int> next(boundaries.starts.begin(), boundaries.starts.end() - 1);
    int number = 0;
    for (const IntegrationFace& face : solid.faces) {
        boundaries.points[next[face.cells[0]]++] = {number, 1.0};
        boundaries.points[next[face.cells[1]]++] = {number++, -1.0};
    }
    for (const SurfacePoint& point : solid.surface_points)
        boundaries.points[next[point.cell]++] = {number++, 1.0};
    return boundaries;
}

/// Sums phi_a A_q over the points of one cell at a time.
class GradientSum {
  public:
    GradientSum(size_t particles, int functions) : functions_(functions), place_(particles, -1) {}

    void add(const ShapeTable& table, int point, const Vec3& area) {
        const int local = point - table.first_point;
        for (int n = table.starts[local]; n < table.starts[local + 1]; ++n) {
            int& place = place_[table.particles[n]];
            if (place < 0) {
                place = static_cast<int>(particles_.size());
                particles_.push_back(table.particles[n]);
                sums_.resize(sums_.size() + 3 * functions_, 0.0);
            }
            double* sum = sums_.data() + 3 * functions_ * place;
            for (size_t k = 0; k < functions_; ++k)
                for (int j = 0; j < 3; ++j) sum[3 * k + j] += table.values[n * functions_ + k] * area[j];
        }
    }

    void moveTo(CellGradients& cells, double volume) {
        cells.particles.insert(cells.particles.end(), particles_.begin(), particles_.end());
        cells.starts.push_back(static_cast<int>(cells.particles.size()));
        for (double sum : sums_) cells.gradients.push_back(sum / volume);
        for (int particle : particles_) place_[particle] = -1;
        particles_.clear();
        sums_.clear();
    }

  private:
    size_t functions_;
    std::vector<int> place_;  // of a particle in the lists below, or -1
    std::vector<int> particles_;
    std::vector<double> sums_;
};

CellGradients joined(std::vector<CellGradients> parts, int functions, const std::vector<ShapeTable>& tables) {
    CellGradients all;
    all.functions_per_particle = functions;
    all.starts.push_back(0);
    for (CellGradients& part : parts) {
        const int offset = static_cast<int>(all.particles.size());
        for (int end : part.starts) all.starts.push_back(offset + end);
        all.particles.insert(all.particles.end(), part.particles.begin(), part.particles.end());
        all.gradients.insert(all.gradients.end(), part.gradients.begin(), part.gradients.end());
        part = {};
    }
    for (const ShapeTable& table : tables)
        for (size_t state = 0; state < table.evaluations.size(); ++state)
            all.evaluations[state] += table.evaluations[state];
    return all;
}

}  // namespace

CellGradients smoothedGradients(const Discretisation& solid, const SupportGraph& supports,
                                const TrialSpace& space) {
    const QuadraturePoints points{solid};
    const std::vector<ShapeTable> tables = evaluateShapes(points, supports, space);
    const CellBoundaries boundaries = cellBoundaries(solid);
    const int cell_count = static_cast<int>(solid.cells.size());
    const int face_count = static_cast<int>(solid.faces.size());

    std::vector<CellGradients> parts(chunk_count);
    forEachChunk(chunk_count, [&](int chunk) {
        GradientSum sum(solid.particles.size(), space.functionsPerParticle());
        const int end = chunkBegin(chunk + 1, chunk_count, cell_count);
        for (int cell = chunkBegin(chunk, chunk_count, cell_count); cell < end; ++cell) {
            for (int n = boundaries.starts[cell]; n < boundaries.starts[cell + 1]; ++n) {
                const auto [point, sign] = boundaries.points[n];
                int table = static_cast<int>(static_cast<long long>(point) * chunk_count / points.count());
                while (table + 1 < chunk_count && tables[table + 1].first_point <= point) ++table;
                const Vec3& area = point < face_count ? solid.faces[point].area
                                                      : solid.surface_points[point - face_count].area;
                sum.add(tables[table], point, sign * area);
            }
            sum.moveTo(parts[chunk], solid.cells[cell].moments.volume);
        }
    });
    return joined(std::move(parts), space.functionsPerParticle(), tables);
}

}  // namespace sherd
