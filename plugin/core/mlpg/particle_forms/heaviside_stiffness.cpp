#include "core/mlpg/particle_forms/heaviside_stiffness.h"

namespace sherd {
namespace {

/// What the borders are scaled with: K's mean diagonal, since borders far smaller or larger than K would
/// spoil the condition of the whole matrix.
double borderScale(const HeavisideBlocks& blocks) {
    const auto& rows = blocks.rows;
    double sum = 0;
    for (size_t particle = 0; particle < rows.size(); ++particle)
        for (const auto& [other, block] : rows[particle])
            if (other == static_cast<int>(particle)) sum += block.trace() / 3;
    return sum > 0 ? sum / static_cast<double>(rows.size()) : 1;
}

}  // namespace

SparseMatrix heavisideStiffness(const HeavisideBlocks& blocks, const Discretisation& solid,
                                const RigidMotions& motions) {
    const auto& rows = blocks.rows;
    SparseMatrix matrix;
    const int unknowns = 3 * static_cast<int>(rows.size());
    double mean_volume = 0;
    for (const Particle& particle : solid.particles)
        mean_volume += particle.volume / static_cast<double>(rows.size());
    const double scale = borderScale(blocks) / mean_volume;
    const auto border = [&](int unknown, int motion) {
        return scale * solid.particles[unknown / 3].volume * motions.coefficients(unknown, motion);
    };

    matrix.size = unknowns + 6 * motions.componentCount();
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
    for (int component = 0; component < motions.componentCount(); ++component)
        for (int motion = 0; motion < 6; ++motion) {
            for (int unknown = 0; unknown < unknowns; ++unknown) {
                if (motions.componentOfUnknown(unknown) != component) continue;
                matrix.indices.push_back(unknown);
                matrix.values.push_back(border(unknown, motion));
            }
            matrix.starts.push_back(static_cast<int>(matrix.indices.size()));
        }
    return matrix;
}

}  // namespace sherd
