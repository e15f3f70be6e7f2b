#include "core/mlpg/heaviside_stiffness.h"

#include <algorithm>
#include <utility>

namespace sherd {
namespace {

/// K_Pb, one 3 x 3 block per particle b, of every sub-domain P; sorted by b.
using BlockRows = std::vector<std::vector<std::pair<int, Mat3>>>;

/// Force on unit displacement of function b through area A: sigma(phi_b e_j) A, column j.
Mat3 traction(const Vec3& gradient, const Vec3& area, const Elasticity& elasticity) {
    return elasticity.lambda_pa * area * gradient.transpose() +
           elasticity.mu_pa * gradient * area.transpose() +
           elasticity.mu_pa * gradient.dot(area) * Mat3::Identity();
}

void addBlock(std::vector<std::pair<int, Mat3>>& row, int particle, const Mat3& block) {
    for (auto& [existing, sum] : row)
        if (existing == particle) {
            sum += block;
            return;
        }
    row.emplace_back(particle, block);
}

BlockRows assembleBlocks(const Discretisation& solid, ShapeEvaluator& evaluator, const Elasticity& elasticity,
                         EvaluationCounts& counts) {
    BlockRows rows(solid.particles.size());
    ShapeFunctions shapes;
    for (size_t particle = 0; particle < rows.size(); ++particle)
        rows[particle].emplace_back(static_cast<int>(particle), Mat3::Zero());
    for (const IntegrationFace& face : solid.faces) {
        const int from = solid.cells[face.cells[0]].particle, to = solid.cells[face.cells[1]].particle;
        if (from == to) continue;
        ++counts[static_cast<size_t>(evaluator.evaluateBetween(face.centroid, from, to, true, shapes))];
        for (size_t n = 0; n < shapes.particles.size(); ++n) {
            const Mat3 block = traction(shapes.gradients[n], face.area, elasticity);
            addBlock(rows[from], shapes.particles[n], -block);
            addBlock(rows[to], shapes.particles[n], block);
        }
    }
    for (auto& row : rows)
        std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return rows;
}

/// Unit-sized borders would drown K or be drowned by it: they are scaled to K's mean diagonal.
double borderScale(const BlockRows& rows) {
    double sum = 0;
    for (size_t particle = 0; particle < rows.size(); ++particle)
        for (const auto& [other, block] : rows[particle])
            if (other == static_cast<int>(particle)) sum += block.trace() / 3;
    return sum > 0 ? sum / static_cast<double>(rows.size()) : 1;
}

}  // namespace

HeavisideStiffness heavisideStiffness(const Discretisation& solid, const SupportGraph& supports,
                                      const TrialSpace& space, const Elasticity& elasticity,
                                      const RigidMotions& motions) {
    HeavisideStiffness result;
    ShapeEvaluator evaluator(solid, supports, space);
    const BlockRows rows = assembleBlocks(solid, evaluator, elasticity, result.evaluations);

    SparseMatrix& matrix = result.matrix;
    const int unknowns = 3 * static_cast<int>(rows.size());
    double mean_volume = 0;
    for (const Particle& particle : solid.particles)
        mean_volume += particle.volume / static_cast<double>(rows.size());
    const double scale = borderScale(rows) / mean_volume;
    const auto border = [&](int unknown, int motion) {
        return scale * solid.particles[unknown / 3].volume * motions.coefficients(unknown, motion);
    };

    matrix.size = unknowns + 6 * motions.components.count;
    matrix.starts.push_back(0);
    for (int unknown = 0; unknown < unknowns; ++unknown) {
        for (const auto& [particle, block] : rows[unknown / 3])
            for (int j = 0; j < 3; ++j) {
                matrix.indices.push_back(3 * particle + j);
                matrix.values.push_back(block(unknown % 3, j));
            }
        for (int motion = 0; motion < 6; ++motion) {
            matrix.indices.push_back(unknowns + 6 * motions.componentOfUnknown(unknown) + motion);
            matrix.values.push_back(border(unknown, motion));
        }
        matrix.starts.push_back(static_cast<int>(matrix.indices.size()));
    }
    for (int component = 0; component < motions.components.count; ++component)
        for (int motion = 0; motion < 6; ++motion) {
            for (int unknown = 0; unknown < unknowns; ++unknown) {
                if (motions.componentOfUnknown(unknown) != component) continue;
                matrix.indices.push_back(unknown);
                matrix.values.push_back(border(unknown, motion));
            }
            matrix.starts.push_back(static_cast<int>(matrix.indices.size()));
        }
    return result;
}

}  // namespace sherd
