#include "core/mlpg/reduced/peak_reading.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/damage/equivalent_bound.h"
#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/monomials.h"
#include "core/numerics/parallel_chunks.h"
#include "core/stress/surface_traction.h"

namespace sherd {

namespace {

constexpr int far_parts = 8;           // that are read away from the load
constexpr int chunks = 16;             // of work for several cores
constexpr double near_spacings = 1.5;  // beyond a patch: all within is read

/// What the volumetric strains of so many loads are on a part, see VolumetricProjection::dilatation.
struct Dilatations {
    const Eigen::MatrixXf& factors;
    Eigen::Index loads;
    int degree;  ///< of the polynomials
    float share;

    /// Gives the gradient under one load, at a point of a part, its projected trace.
    template <class Gradient>
    void project(std::size_t part, Eigen::Index load, const Vec3& xi, Gradient&& gradient) const {
        if (factors.size() == 0) return;
        const Eigen::Index monomials = factors.rows() / loads;
        const auto own = factors.col(static_cast<Eigen::Index>(part)).segment(load * monomials, monomials);
        projectTrace(gradient, polynomialAt(degree, own, Eigen::Vector3f(xi.cast<float>())), share);
    }
};

}  // namespace

/// Coefficients of all functions under all loads: column by function, 3 numbers a load.
Eigen::MatrixXf PeakReading::expand(const Eigen::MatrixXd& displacements) const {
    const SplineSpace& space = *problem_.space;
    const Eigen::MatrixXf by_load = displacements.transpose().cast<float>();  // #loads x #unknowns
    const Eigen::Index loads = by_load.rows();
    Eigen::MatrixXf raw = Eigen::MatrixXf::Zero(3 * loads, space.raw_count);
    forEachChunk(chunks, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunks, space.raw_count);
        for (int r = chunkBegin(chunk, chunks, space.raw_count); r < end; ++r)
            for (const SplineTies::Term& term : space.termsOf(r))
                for (int axis = 0; axis < 3; ++axis)
                    raw.col(r)(Eigen::seqN(axis, loads, 3)) +=
                        static_cast<float>(term.factor) * by_load.col(3L * term.function + axis);
    });
    return raw;
}

PeakReading::PeakReading(const SplineProblem& problem, const std::vector<GridPoint>& samples,
                         const Material& material)
    : problem_(problem),
      samples_(samples),
      material_(material),
      criterion_(*failureCriterion(material.failure_criterion)),
      bound_(criterion_, material),
      of_part_(problem.parts().parts.size()),
      middles_(of_part_.size(), Vec3::Zero()) {
    for (std::size_t s = 0; s < samples.size(); ++s)
        if (samples[s].part >= 0) of_part_[samples[s].part].push_back(static_cast<int>(s));
    for (std::size_t part = 0; part < of_part_.size(); ++part)
        for (const int sample : of_part_[part])
            middles_[part] += placeOf(sample) / static_cast<double>(of_part_[part].size());
}

Vec3 PeakReading::placeOf(int sample) const {
    const Discretisation& solid = *problem_.solid;
    const auto particles = static_cast<int>(solid.particles.size());
    return sample < particles ? solid.particles[sample].position
                              : solid.surface_points[sample - particles].position;
}

/// The projected volumetric strain under all loads, or nothing where the displacement's own counts.
Eigen::MatrixXf PeakReading::dilatationOf(const Eigen::MatrixXf& raw) const {
    return problem_.projection ? problem_.projection->dilatation<float>(raw) : Eigen::MatrixXf{};
}

/// Per patch the parts with the largest stress in their middle.
std::vector<std::vector<int>> PeakReading::mostStressedParts(const Eigen::MatrixXf& raw) const {
    const Eigen::Index patches = raw.rows() / 9;
    const SplineSpace& space = *problem_.space;
    std::vector<Vec3> slopes;
    splineGradients(space.degree, Vec3::Zero(), slopes);
    for (Vec3& slope : slopes) slope = slope.cwiseQuotient(problem_.parts().edges);
    const auto lambda = static_cast<float>(problem_.elasticity.lambda_pa);
    const auto mu = static_cast<float>(problem_.elasticity.mu_pa);
    const Eigen::MatrixXf dilatation = dilatationOf(raw);
    const Dilatations dilatations{dilatation, 3 * patches, dilatationDegree(space.degree),
                                  static_cast<float>(projectedShare(problem_.elasticity))};
    Eigen::MatrixXf sizes = Eigen::MatrixXf::Zero(patches, static_cast<Eigen::Index>(of_part_.size()));
    Eigen::MatrixX3f columns(raw.rows(), 3);
    for (std::size_t part = 0; part < of_part_.size(); ++part) {
        if (of_part_[part].empty()) continue;
        columns.setZero();
        const std::vector<int>& functions = space.raw_of[part];
        for (std::size_t a = 0; a < functions.size(); ++a)
            for (int j = 0; j < 3; ++j)
                columns.col(j) += static_cast<float>(slopes[a][j]) * raw.col(functions[a]);
        for (Eigen::Index load = 0; load < 3 * patches; ++load) {
            Eigen::Matrix3f gradient = columns.middleRows<3>(3 * load);
            dilatations.project(part, load, Vec3::Zero(), gradient);
            const Eigen::Matrix3f stress = lambda * gradient.trace() * Eigen::Matrix3f::Identity() +
                                           mu * (gradient + gradient.transpose());
            sizes(load / 3, static_cast<Eigen::Index>(part)) += stress.squaredNorm();
        }
    }
    std::vector<std::vector<int>> most;
    std::vector<int> order(of_part_.size());
    const int count = std::min<int>(far_parts, static_cast<int>(order.size()));
    for (Eigen::Index patch = 0; patch < patches; ++patch) {
        std::iota(order.begin(), order.end(), 0);
        std::partial_sort(order.begin(), order.begin() + count, order.end(), [&](int a, int b) {
            return std::make_pair(-sizes(patch, a), a) < std::make_pair(-sizes(patch, b), b);
        });
        most.emplace_back(order.begin(), order.begin() + count);
    }
    return most;
}

/// Which patches read each part, ascending: of those from `first` to `last`.
std::vector<std::vector<int>> PeakReading::readersOf(const Read& read, int first, int last) const {
    const double reach = read.radius_m + near_spacings * problem_.solid->spacing;
    std::vector<std::vector<int>> readers(of_part_.size());
    for (int p = first; p < last; ++p) {
        std::vector<int> parts = read.far[p];
        for (std::size_t part = 0; part < of_part_.size(); ++part)
            if ((middles_[part] - read.patches[p].middle.cast<double>()).squaredNorm() <= reach * reach)
                parts.push_back(static_cast<int>(part));
        std::sort(parts.begin(), parts.end());
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        for (const int part : parts) readers[part].push_back(p);
    }
    return readers;
}

/// The largest equivalent stress of each patch under 1 N in each of its directions, Pa.
std::vector<PeakReading::Peaks> PeakReading::read(const Read& read) const {
    const auto count = static_cast<int>(read.patches.size());
    std::vector<Peaks> peaks(read.patches.size());
    const Eigen::MatrixXf dilatation = dilatationOf(read.raw);
    forEachChunk(chunks, [&](int chunk) {
        readChunk(read, dilatation, chunkBegin(chunk, chunks, count), chunkBegin(chunk + 1, chunks, count),
                  peaks);
    });
    return peaks;
}

void PeakReading::readChunk(const Read& read, const Eigen::MatrixXf& dilatation, int first, int last,
                            std::vector<Peaks>& peaks) const {
    const std::vector<std::vector<int>> readers = readersOf(read, first, last);
    std::vector<Directions> directions(static_cast<std::size_t>(last - first));
    for (int p = first; p < last; ++p)
        for (int d = 0; d < PeakTable::directions; ++d)
            directions[p - first][d] = read.patches[p].direction(d).cast<double>();

    const Dilatations dilatations{dilatation, read.raw.rows() / 3, dilatationDegree(problem_.space->degree),
                                  static_cast<float>(projectedShare(problem_.elasticity))};
    const Vec3 per_edge = problem_.parts().edges.cwiseInverse();
    std::vector<Vec3> slopes;
    Eigen::MatrixXf own;
    Eigen::MatrixX3f gradients;
    for (std::size_t part = 0; part < of_part_.size(); ++part) {
        if (of_part_[part].empty() || readers[part].empty()) continue;
        const std::vector<int>& functions = problem_.space->raw_of[part];
        const auto count = static_cast<Eigen::Index>(readers[part].size());
        own.resize(9 * count, static_cast<Eigen::Index>(functions.size()));
        for (std::size_t a = 0; a < functions.size(); ++a)
            for (Eigen::Index r = 0; r < count; ++r)
                own.block<9, 1>(9 * r, static_cast<Eigen::Index>(a)) =
                    read.raw.block<9, 1>(9L * readers[part][r], functions[a]);
        for (const int sample : of_part_[part]) {
            splineGradients(problem_.space->degree, samples_[sample].xi, slopes);
            gradients.setZero(9 * count, 3);
            for (std::size_t a = 0; a < functions.size(); ++a)
                for (int j = 0; j < 3; ++j)
                    gradients.col(j) += static_cast<float>(slopes[a][j] * per_edge[j]) *
                                        own.col(static_cast<Eigen::Index>(a));
            for (Eigen::Index r = 0; r < count; ++r) {
                const int p = readers[part][r];
                for (Eigen::Index k = 0; k < 3; ++k)
                    dilatations.project(part, 3L * p + k, samples_[sample].xi,
                                        gradients.middleRows<3>(9 * r + 3 * k));
                include(sample, gradients.middleRows<9>(9 * r), read.patches[p], read.radius_m,
                        directions[p - first], peaks[p]);
            }
        }
    }
}

void PeakReading::include(int sample, const Eigen::Matrix<float, 9, 3>& gradients,
                          const PeakTable::Patch& patch, double radius, const Directions& directions,
                          Peaks& peaks) const {
    SymmetricTensor units[3];
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
        units[k] =
            toSymmetricTensor(problem_.elasticity.stress(gradients.middleRows<3>(3 * k).cast<double>()));
        squared += units[k].squaredNorm() + units[k].tail<3>().squaredNorm();
    }
    // Clearing the surface of traction may add as much again.
    const double most = 2 * (bound_.of_tension + bound_.of_pressure) * std::sqrt(squared);
    if (most <= *std::min_element(peaks.begin(), peaks.end())) return;

    const Discretisation& solid = *problem_.solid;
    const int point_number = sample - static_cast<int>(solid.particles.size());
    const SurfacePoint* point = point_number >= 0 ? &solid.surface_points[point_number] : nullptr;
    const bool is_cleared = point && !point->normal.isZero();
    // Near a load the surface is not cleared; how near is a matter of the load.
    const double near_load = radius + 2 * solid.spacing;
    const bool is_read =
        !is_cleared || (point->position - patch.middle.cast<double>()).squaredNorm() < near_load * near_load;
    SymmetricTensor cleared[3];
    for (int k = 0; is_cleared && k < 3; ++k)
        cleared[k] = withTraction(units[k], point->normal, Vec3::Zero(), problem_.elasticity);
    for (int d = 0; d < PeakTable::directions; ++d) {
        if (most <= peaks[d]) continue;
        const Vec3& f = directions[d];
        if (is_read) raise(f[0] * units[0] + f[1] * units[1] + f[2] * units[2], peaks[d]);
        if (is_cleared) raise(f[0] * cleared[0] + f[1] * cleared[1] + f[2] * cleared[2], peaks[d]);
    }
}

void PeakReading::raise(const SymmetricTensor& stress, float& peak) const {
    const double mean = stress.head<3>().sum() / 3;
    const double squared =
        (stress.head<3>().array() - mean).square().sum() + 2 * stress.tail<3>().squaredNorm();
    const double deviator = std::sqrt(2.0 / 3 * squared);
    if (bound_(std::min(0.0, mean - deviator), std::max(0.0, mean + deviator)) <= peak) return;
    const double equivalent = criterion_.equivalent_stress_pa(principalStresses(stress), material_);
    peak = std::max(peak, static_cast<float>(equivalent));
}

}  // namespace sherd
