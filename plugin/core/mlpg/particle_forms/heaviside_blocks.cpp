#include "core/mlpg/particle_forms/heaviside_blocks.h"

#include <algorithm>

namespace sherd {
namespace {

void addBlock(std::vector<std::pair<int, Mat3>>& row, int particle, const Mat3& block) {
    for (auto& [existing, sum] : row)
        if (existing == particle) {
            sum += block;
            return;
        }
    row.emplace_back(particle, block);
}

}  // namespace

HeavisideBlocks fluxThroughSharedFaces(const StressProblem& problem) {
    const Discretisation& solid = problem.solid;
    ShapeEvaluator evaluator(solid, problem.supports, problem.space);
    ShapeFunctions shapes;
    HeavisideBlocks blocks;
    blocks.rows.resize(solid.particles.size());
    for (size_t particle = 0; particle < blocks.rows.size(); ++particle)
        blocks.rows[particle].emplace_back(static_cast<int>(particle), Mat3::Zero());
    for (const IntegrationFace& face : solid.faces) {
        const int from = solid.cells[face.cells[0]].particle, to = solid.cells[face.cells[1]].particle;
        if (from == to) continue;
        const Evaluation state = evaluator.evaluateBetween(face.centroid, from, to, true, shapes);
        ++blocks.evaluations[static_cast<size_t>(state)];
        for (size_t n = 0; n < shapes.particles.size(); ++n) {
            const Mat3 block = fluxBlock(shapes.gradients[n], face.area, problem.elasticity);
            addBlock(blocks.rows[from], shapes.particles[n], -block);
            addBlock(blocks.rows[to], shapes.particles[n], block);
        }
    }
    for (auto& row : blocks.rows)
        std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return blocks;
}

}  // namespace sherd
