#include "core/mlpg/reduced/damage_reading.h"

#include <algorithm>

#include "core/mlpg/splines/b_spline.h"
#include "core/stress/loaded_places.h"
#include "core/stress/surface_traction.h"

namespace sherd {

namespace {

constexpr double near_to_failure = 0.5;  // overstress from which it steers cracks

/// An upper bound of the equivalent stress for all principal stresses in a range. Criteria are convex and
/// proportional to the stress, so that eq(a + b) <= eq(a) + eq(b): of tensions and pressures each.
struct EquivalentBound {
    double of_tension = 0, of_pressure = 0;

    explicit EquivalentBound(const Strength& strength) {
        const auto at = [&](const PrincipalStresses& stress) {
            return strength.criterion.equivalent_stress_pa(stress, strength.material);
        };
        of_tension = std::max({0.0, at({1, 0, 0}), at({1, 1, 0}), at({1, 1, 1})});
        of_pressure = std::max({0.0, at({0, 0, -1}), at({0, -1, -1}), at({-1, -1, -1})});
    }
    double operator()(const PrincipalRange& range) const {
        return of_tension * range.largest - of_pressure * range.smallest;
    }
};

}  // namespace

DamageReading::DamageReading(std::shared_ptr<const SplineProblem> problem, std::vector<GridPoint> samples)
    : DamageReading(problem, samples,
                    StressBounds(problem->parts(), problem->space->degree, problem->elasticity, samples)) {}

DamageReading::DamageReading(std::shared_ptr<const SplineProblem> problem, std::vector<GridPoint> samples,
                             StressBounds bounds)
    : problem_(std::move(problem)),
      samples_(std::move(samples)),
      powers_(splinePowers(problem_->space->degree).cast<float>()),
      bounds_(std::move(bounds)) {
    const Discretisation& solid = *problem_->solid;
    const std::size_t particles = solid.particles.size(), part_count = problem_->parts().parts.size();
    starts_.assign(part_count + 1, 0);
    for (std::size_t s = 0; s < samples_.size(); ++s) {
        particle_of_.push_back(s < particles
                                   ? static_cast<int>(s)
                                   : solid.cells[solid.surface_points[s - particles].cell].particle);
        if (samples_[s].part >= 0) ++starts_[samples_[s].part + 1];
    }
    for (std::size_t p = 0; p < part_count; ++p) starts_[p + 1] += starts_[p];
    of_part_.resize(static_cast<std::size_t>(starts_.back()));
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t s = 0; s < samples_.size(); ++s)
        if (samples_[s].part >= 0) of_part_[next[samples_[s].part]++] = static_cast<int>(s);
}

Eigen::Matrix4Xf DamageReading::expand(const Eigen::VectorXf& unknowns) const {
    const SplineSpace& space = *problem_->space;
    Eigen::Matrix4Xf raw = Eigen::Matrix4Xf::Zero(4, space.raw_count);
    for (int r = 0; r < space.raw_count; ++r)
        for (const SplineTies::Term& term : space.termsOf(r))
            raw.col(r).head<3>() += static_cast<float>(term.factor) * unknowns.segment<3>(3L * term.function);
    return raw;
}

/// Reads the stress of one displacement, part by part.
class DamageReading::Reader {
  public:
    Reader(const DamageReading& of, const Eigen::Matrix4Xf& raw, const std::vector<PointForce>& loads,
           double scale, const Strength& strength)
        : of_(of),
          raw_(raw),
          loaded_(loads, of.problem_->solid->spacing),
          scale_(scale),
          strength_(strength),
          bound_(strength),
          equivalent(of.problem_->solid->particles.size(), 0.0) {}

    /// Reads the samples of a part that may be as near to failure as `overstress`, or under the largest
    /// tension.
    void read(int part, double overstress) {
        const Discretisation& solid = *of_.problem_->solid;
        const Elasticity& elasticity = of_.problem_->elasticity;
        const int particles = static_cast<int>(solid.particles.size());
        for (int at = of_.starts_[part]; at < of_.starts_[part + 1]; ++at) {
            const int sample = of_.of_part_[at], particle = of_.particle_of_[sample];
            const Mat3 raw_stress = elasticity.stress(gradientAt(of_.samples_[sample]).cast<double>());
            SymmetricTensor stress = toSymmetricTensor(raw_stress);
            const float coupling = sample < particles ? 0 : 1;
            const PrincipalRange range = principalRange(raw_stress.cast<float>(), 0, coupling);
            if (range.largest <= tension &&
                scale_ * bound_(range) < overstress * strength_.of_particle[particle])
                continue;
            if (sample >= particles) {
                const SurfacePoint& point = solid.surface_points[sample - particles];
                if (!point.normal.isZero() && !loaded_.isNear(point.position))
                    stress = withTraction(stress, point.normal, Vec3::Zero(), elasticity);
            }
            const PrincipalStresses principal = principalStresses(stress);
            equivalent[particle] = std::max(equivalent[particle], strength_.criterion.equivalent_stress_pa(
                                                                      principal, strength_.material));
            tension = std::max(tension, principal.largest);
        }
    }

  private:
    /// Displacement gradient, summed one direction after the other.
    Eigen::Matrix3f gradientAt(const GridPoint& at) const {
        using Quad = Eigen::Array4f;
        constexpr int most = largest_spline_degree + 1;
        const int w = static_cast<int>(of_.powers_.cols());
        float values[3][most], slopes[3][most];
        for (int d = 0; d < 3; ++d) {
            const float xi = static_cast<float>(at.xi[d]);
            for (int a = 0; a < w; ++a) {
                float value = 0, slope = 0;
                for (int k = w - 1; k >= 0; --k) {
                    slope = slope * xi + value;
                    value = value * xi + of_.powers_(k, a);
                }
                values[d][a] = value;
                slopes[d][a] = slope;
            }
        }
        const std::vector<int>& functions = of_.problem_->space->raw_of[at.part];
        Quad by_x = Quad::Zero(), by_y = Quad::Zero(), by_z = Quad::Zero();
        int f = 0;
        for (int c = 0; c < w; ++c) {
            Quad plane = Quad::Zero(), plane_x = Quad::Zero(), plane_y = Quad::Zero();
            for (int b = 0; b < w; ++b) {
                Quad line = Quad::Zero(), line_x = Quad::Zero();
                for (int a = 0; a < w; ++a) {
                    const Quad own = raw_.col(functions[f++]).array();
                    line += values[0][a] * own;
                    line_x += slopes[0][a] * own;
                }
                plane += values[1][b] * line;
                plane_x += values[1][b] * line_x;
                plane_y += slopes[1][b] * line;
            }
            by_x += values[2][c] * plane_x;
            by_y += values[2][c] * plane_y;
            by_z += slopes[2][c] * plane;
        }
        const Eigen::Array3f edges = of_.problem_->parts().edges.cast<float>().array();
        Eigen::Matrix3f gradient;
        gradient.col(0) = by_x.head<3>() / edges[0];
        gradient.col(1) = by_y.head<3>() / edges[1];
        gradient.col(2) = by_z.head<3>() / edges[2];
        return gradient;
    }

    const DamageReading& of_;
    const Eigen::Matrix4Xf& raw_;
    LoadedPlaces loaded_;
    double scale_;
    const Strength& strength_;
    EquivalentBound bound_;

  public:
    std::vector<double> equivalent;  ///< per particle, the largest that was read
    double tension = 0;              ///< the largest that was read
};

Damage DamageReading::damage(const Eigen::VectorXf& unknowns, const std::vector<PointForce>& loads,
                             double scale, const Strength& strength) const {
    const Eigen::Matrix4Xf raw = expand(unknowns);
    Reader reader(*this, raw, loads, scale, strength);
    const EquivalentBound equivalent_bound(strength);
    const double weakest = *std::min_element(strength.of_particle.begin(), strength.of_particle.end());
    const int part_count = static_cast<int>(starts_.size()) - 1;

    std::vector<double> overstress_bound(static_cast<std::size_t>(part_count), 0.0);
    std::vector<std::pair<float, int>> by_tension;
    for (int part = 0; part < part_count; ++part) {
        if (starts_[part] == starts_[part + 1]) continue;
        const PrincipalRange range = bounds_.range(raw, problem_->space->raw_of[part], part);
        overstress_bound[part] = scale * equivalent_bound(range) / weakest;
        by_tension.push_back({range.largest, part});
    }
    // From the highest bound down, so that few parts are read before the largest stress is known.
    std::sort(by_tension.begin(), by_tension.end(), [](const auto& a, const auto& b) {
        return a.first > b.first || (a.first == b.first && a.second < b.second);
    });
    for (const auto& [tension, part] : by_tension)
        if (tension > reader.tension || overstress_bound[part] >= 1) reader.read(part, 1);

    Damage damage;
    damage.damaged.resize(strength.of_particle.size());
    damage.overstress.resize(strength.of_particle.size());
    const auto count = [&] {
        damage.count = 0;
        for (std::size_t i = 0; i < reader.equivalent.size(); ++i) {
            damage.overstress[i] = scale / strength.of_particle[i] * reader.equivalent[i];
            damage.damaged[i] = damage.overstress[i] > 1;
            damage.count += damage.damaged[i];
        }
    };
    count();
    if (damage.count > 0) {  // what is near to failure steers the cracks
        for (int part = 0; part < part_count; ++part)
            if (overstress_bound[part] >= near_to_failure) reader.read(part, near_to_failure);
        count();
    }
    damage.largest_stress_pa = scale * reader.tension;
    return damage;
}

}  // namespace sherd
