#include "core/mlpg/particle_forms/stress_recovery.h"

#include "core/mlpg/particle_forms/centred_fit.h"
#include "core/mlpg/particle_forms/weight_function.h"
#include "core/numerics/parallel_chunks.h"
#include "core/stress/elasticity.h"

namespace sherd {
namespace {

constexpr int chunk_count = 16;
constexpr double fit_radius =
    1.1;  // in support radii: the oscillations that are to be smoothed away are as long as the supports
constexpr double smallest_spread =
    0.03;  // in particle spacings: cells closer to a plane than that give no slope across it

}  // namespace

StressRecovery::StressRecovery(const Discretisation& solid, const SupportGraph& supports,
                               double support_radius)
    : solid_(&solid), fit_radius_(fit_radius * support_radius), balls_(supports.balls(fit_radius_ + 1)) {
    const int particles = static_cast<int>(solid.particles.size());
    const int points = particles + static_cast<int>(solid.surface_points.size());
    std::vector<std::vector<Term>> fits(points);
    forEachChunk(chunk_count, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunk_count, points);
        for (int point = chunkBegin(chunk, chunk_count, points); point < end; ++point) {
            if (point < particles) {
                fit(solid.particles[point].position, point, fits[point]);
                continue;
            }
            const SurfacePoint& surface = solid.surface_points[point - particles];
            fit(surface.position, solid.cells[surface.cell].particle, fits[point]);
        }
    });
    starts_.push_back(0);
    for (const std::vector<Term>& terms : fits) {
        terms_.insert(terms_.end(), terms.begin(), terms.end());
        starts_.push_back(static_cast<int>(terms_.size()));
    }
}

void StressRecovery::fit(const Vec3& x, int owner, std::vector<Term>& terms) const {
    const double spacing = solid_->particles[owner].spacing;
    // Weights are centred between the point and its particle: about the point itself, fits at the surface
    // would see one side only and lean on the outermost cells; about the particle, all of its points would
    // share one fit.
    const Vec3 centre = (x + solid_->particles[owner].position) / 2;
    terms.clear();
    // A point that no cell is near (beside the solid) is fitted from farther away.
    for (double radius = fit_radius_ * spacing; terms.empty(); radius *= 1.5) {
        CentredFit fit;
        for (int neighbour : balls_[owner])
            for (int cell : solid_->particle_cells[neighbour]) {
                const Moments& moments = solid_->cells[cell].moments;
                const double weight =
                    moments.volume * splineWeight((moments.centroid - centre).norm() / radius);
                if (weight <= 0) continue;
                fit.add(moments.centroid, weight);
                terms.push_back({cell, weight});
            }
        if (terms.empty()) continue;
        fit.finish(smallest_spread * spacing);
        for (Term& term : terms)
            term.factor = fit.factorAt(x, solid_->cells[term.cell].moments.centroid, term.factor);
    }
}

SymmetricTensor StressRecovery::recoverAt(const std::vector<Mat3>& cells, const Vec3& x, int owner) const {
    std::vector<Term> terms;
    fit(x, owner, terms);
    SymmetricTensor stress = SymmetricTensor::Zero();
    for (const Term& term : terms) stress += term.factor * toSymmetricTensor(cells[term.cell]);
    return stress;
}

void StressRecovery::recover(const std::vector<Mat3>& cells, std::vector<SymmetricTensor>& particles,
                             std::vector<SymmetricTensor>& surface) const {
    std::vector<SymmetricTensor> stresses(cells.size());
    for (size_t cell = 0; cell < cells.size(); ++cell) stresses[cell] = toSymmetricTensor(cells[cell]);
    particles.assign(solid_->particles.size(), SymmetricTensor::Zero());
    surface.assign(solid_->surface_points.size(), SymmetricTensor::Zero());
    const int count = static_cast<int>(particles.size());
    const int points = static_cast<int>(starts_.size()) - 1;
    forEachChunk(chunk_count, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunk_count, points);
        for (int point = chunkBegin(chunk, chunk_count, points); point < end; ++point) {
            SymmetricTensor& stress = point < count ? particles[point] : surface[point - count];
            for (int n = starts_[point]; n < starts_[point + 1]; ++n)
                stress += terms_[n].factor * stresses[terms_[n].cell];
        }
    });
}

}  // namespace sherd
