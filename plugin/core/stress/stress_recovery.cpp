#include "core/stress/stress_recovery.h"

#include "core/mls/centred_fit.h"
#include "core/mls/weight_function.h"
#include "core/stress/elasticity.h"

namespace sherd {
namespace {

constexpr double fit_radius = 1.5;       // in particle spacings
constexpr double smallest_spread = 0.03;  // in particle spacings: cells closer to a plane than that give no slope across it

}  // namespace

StressRecovery::StressRecovery(const Discretisation& solid, const SupportGraph& supports) : solid_(&solid) {
    const std::vector<std::vector<int>> balls = supports.balls(fit_radius);
    starts_.push_back(0);
    for (size_t particle = 0; particle < solid.particles.size(); ++particle) {
        const Particle& centre = solid.particles[particle];
        const auto weightOf = [&](int cell) {
            const Moments& moments = solid.cells[cell].moments;
            const double distance = (moments.centroid - centre.position).norm();
            return moments.volume * splineWeight(distance / (fit_radius * centre.spacing));
        };
        CentredFit fit;
        std::vector<int> cells;
        for (int neighbour : balls[particle])
            for (int cell : solid.particle_cells[neighbour])
                if (weightOf(cell) > 0) cells.push_back(cell);
        for (int cell : cells) fit.add(solid.cells[cell].moments.centroid, weightOf(cell));
        if (!fit.finish(smallest_spread * centre.spacing)) {
            // All cells out of reach: a sub-domain much larger than its spacing. Its own cells, plainly averaged.
            cells = solid.particle_cells[particle];
            for (int cell : cells) fit.add(centre.position, solid.cells[cell].moments.volume);
            fit.finish(smallest_spread * centre.spacing);
            for (int cell : cells)
                terms_.push_back({cell, fit.valueFactor(solid.cells[cell].moments.volume), Vec3::Zero()});
        } else {
            for (int cell : cells)
                terms_.push_back({cell, fit.valueFactor(weightOf(cell)),
                                  fit.slopeFactor(solid.cells[cell].moments.centroid, weightOf(cell))});
        }
        means_.push_back(fit.mean());
        starts_.push_back(static_cast<int>(terms_.size()));
    }
}

void StressRecovery::recover(const std::vector<Mat3>& cells, std::vector<Voigt>& particles,
                             std::vector<Voigt>& surface) const {
    const size_t count = solid_->particles.size();
    std::vector<Voigt> values(count);
    std::vector<Eigen::Matrix<double, 6, 3>> slopes(count);
    particles.resize(count);
    for (size_t particle = 0; particle < count; ++particle) {
        values[particle].setZero();
        slopes[particle].setZero();
        for (int n = starts_[particle]; n < starts_[particle + 1]; ++n) {
            const Voigt stress = toVoigt(cells[terms_[n].cell]);
            values[particle] += terms_[n].value * stress;
            slopes[particle] += stress * terms_[n].slope.transpose();
        }
        particles[particle] = values[particle] + slopes[particle] * (solid_->particles[particle].position - means_[particle]);
    }
    surface.resize(solid_->surface_points.size());
    for (size_t point = 0; point < surface.size(); ++point) {
        const SurfacePoint& at = solid_->surface_points[point];
        const int owner = solid_->cells[at.cell].particle;
        surface[point] = values[owner] + slopes[owner] * (at.position - means_[owner]);
    }
}

}  // namespace sherd
