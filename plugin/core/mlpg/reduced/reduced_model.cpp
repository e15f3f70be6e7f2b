#include "core/mlpg/reduced/reduced_model.h"

#include <algorithm>
#include <cmath>

#include "core/linear_algebra/block_product.h"
#include "core/linear_algebra/dense_kernels.h"
#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/particle_mass.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

constexpr double wanted_local_share = 0.4;  // at most, in small solids

constexpr double largest_rounding = 1e-3;  // of the energy of a mode

/// What of the ball about a solid it fills.
double compactness(const Discretisation& solid) {
    double volume = 0, squared_radius = 0;
    Vec3 middle = Vec3::Zero();
    for (const Particle& particle : solid.particles) {
        volume += particle.volume;
        middle += particle.volume * particle.position;
    }
    middle /= volume;
    for (const Particle& particle : solid.particles)
        squared_radius = std::max(squared_radius, (particle.position - middle).squaredNorm());
    const double radius = std::sqrt(squared_radius) + 0.5 * solid.parts.edges.mean();
    return volume / (4 * pi / 3 * radius * radius * radius);
}

}  // namespace

ReducedModel::ReducedModel(std::shared_ptr<const SplineProblem> problem, PackedStiffness stiffness,
                           ProperModes modes, VibrationModes vibrations, const ReducedModelLimits& limits)
    : problem_(std::move(problem)),
      stiffness_(std::move(stiffness)),
      modes_(std::move(modes)),
      vibrations_(std::move(vibrations)),
      local_(*problem_),
      limits_(limits),
      functions_of_component_(static_cast<std::size_t>(problem_->space->component_count), 0) {
    for (const int component : problem_->space->component) ++functions_of_component_[component];
    const int smallest = *std::min_element(functions_of_component_.begin(), functions_of_component_.end());
    most_local_ = std::min(limits_.local_functions, static_cast<int>(wanted_local_share * smallest));
    // A ball has 1, a cylinder as high as wide 0.53. A cube, 0.37, has 7 % without, and takes as long again
    // with.
    constexpr double compact = 0.4;
    constexpr int rounds = 4;  // each leaves a half to a third of the error
    // A solid that is held somewhere sways on that, which 16 bits of stiffness have wrong, and modes have
    // not.
    const bool is_free =
        std::none_of(problem_->held.begin(), problem_->held.end(), [](char held) { return held; });
    if (is_free && compactness(*problem_->solid) > compact) refinements_ = rounds;
}

Result<ReducedModel> ReducedModel::make(std::shared_ptr<const SplineProblem> problem,
                                        const BlockMatrix& stiffness, const UnitResponses& unit,
                                        const ReducedModelLimits& limits) {
    auto modes = ProperModes::make(*problem, unit, limits.modes, diagonalOf(stiffness));
    if (!modes) return Error{modes.error()};
    VibrationModes vibrations = VibrationModes::make(*problem, modes.value());
    ReducedModel model(std::move(problem), PackedStiffness(stiffness), std::move(modes).value(),
                       std::move(vibrations), limits);
    constexpr int least_local_parts = 4;
    if (model.most_local_ < least_local_parts * model.problem_->space->perPart())
        return Error{
            "The solid is too small for a reduced model; use a smaller spacing or a higher quality."};
    if (model.roundingOfModes(stiffness) > largest_rounding)
        return Error{"The solid is too slender for a reduced model in 16 bits; blows are solved fully."};
    return model;
}

Result<ReducedModel> ReducedModel::makeDirect(std::shared_ptr<const SplineProblem> problem,
                                              const SparseSolver& factor, const std::vector<int>& pinned,
                                              const UnitResponses& unit, const Progress& progress) {
    auto compliance = ComplianceMatrix::make(*problem, factor, pinned, progress);
    if (!compliance) return Error{compliance.error()};
    ProperModes modes;
    VibrationModes vibrations;
    if (auto made = ProperModes::make(*problem, unit, ReducedModelLimits{}.modes)) {
        modes = std::move(made).value();
        vibrations = VibrationModes::make(*problem, modes);
    }
    return ReducedModel(std::move(problem), std::move(compliance).value(), std::move(modes),
                        std::move(vibrations));
}

ReducedModel::ReducedModel(std::shared_ptr<const SplineProblem> problem, ComplianceMatrix compliance,
                           ProperModes modes, VibrationModes vibrations)
    : ReducedModel(std::move(problem), {}, std::move(modes), std::move(vibrations), {}) {
    compliance_ = std::move(compliance);
}

/// The largest energy of what 16 bits take from the softest modes, of which each has 1/2: slender solids move
/// far and strain little.
double ReducedModel::roundingOfModes(const BlockMatrix& stiffness) const {
    constexpr int softest = 4;
    double largest = 0;
    for (int m = 0; m < std::min(softest, modes_.count); ++m) {
        const Eigen::VectorXd mode =
            modes_.displacement(Eigen::VectorXf::Unit(modes_.count, m)).cast<double>();
        largest = std::max(largest, std::abs(mode.dot(blockProduct(stiffness, mode)) - 1));
    }
    return largest;
}

/// The forces of the loads at the unknowns; prepares what answers them.
Result<Eigen::VectorXd> ReducedModel::forcesOf(const std::vector<PointForce>& loads,
                                               LocalSystem& kept) const {
    Result<Eigen::VectorXd> forces = forcesAt(*problem_, loads);
    if (!forces || isDirect()) return forces;
    const Status ready = prepareAbout(local_.around(loads, most_local_), kept);
    return ready ? std::move(forces) : Error{ready.error()};
}

Result<ReducedResponse> ReducedModel::respond(const std::vector<PointForce>& loads, LocalSystem& kept) const {
    const auto forces = forcesOf(loads, kept);
    if (!forces) return Error{forces.error()};
    return respond(forces.value(), kept);
}

Result<double> ReducedModel::strainEnergy(const std::vector<PointForce>& loads, LocalSystem& kept) const {
    const auto forces = forcesOf(loads, kept);
    if (!forces) return Error{forces.error()};
    if (isDirect()) {
        const auto response = respond(forces.value(), kept);
        if (!response) return Error{response.error()};
        return response.value().strain_energy_j;
    }
    const auto solution = solve(forces.value(), kept);
    if (!solution) return Error{solution.error()};
    return solution.value().strain_energy_j;
}

Result<ReducedResponse> ReducedModel::respond(const Eigen::VectorXd& forces,
                                              const LocalSystem& system) const {
    auto response = respondInModes(forces, system);
    if (response && refinements_ > 0 && !isDirect()) refine(forces, response.value());
    return response;
}

Result<ReducedResponse> ReducedModel::respondInModes(const Eigen::VectorXd& forces,
                                                     const LocalSystem& system) const {
    if (isDirect()) return compliance_.respond(forces.cast<float>());
    const auto solution = solve(forces, system);
    if (!solution) return Error{solution.error()};
    return responseOf(solution.value(), system);
}

/// Adds what the modes and the functions about the loads lack.
void ReducedModel::refine(const Eigen::VectorXd& forces, ReducedResponse& response) const {
    Eigen::VectorXd balanced = forces;
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants = problem_->motions.resultants(forces);
    clearHeld(*problem_, resultants);
    problem_->inertia.balance(balanced, resultants, problem_->motions);
    const Eigen::VectorXf rest = balanced.cast<float>() - stiffness_.times(response.unknowns);
    const Eigen::VectorXf more = stiffness_.solveRoughly(rest, refinements_);
    if (!more.allFinite()) return;
    response.unknowns += more;
    response.strain_energy_j += 0.5 * double(more.dot(rest));
}

/// V^T f: inertia does none on the modes.
Eigen::VectorXf ReducedModel::workOnModes(const Eigen::VectorXd& forces) const {
    Eigen::VectorXf work = Eigen::VectorXf::Zero(modes_.count);
    for (Eigen::Index unknown = 0; unknown < forces.size(); ++unknown)
        if (const auto force = static_cast<float>(forces[unknown]); force != 0)
            modes_.addWork(static_cast<int>(unknown), force, work);
    return work;
}

Result<ReducedModel::Solution> ReducedModel::solve(const Eigen::VectorXd& forces,
                                                   const LocalSystem& system) const {
    if (system.modes_factor.size() == 0)
        return Error{"The reduced equations are not prepared for any loads."};
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants = problem_->motions.resultants(forces);
    clearHeld(*problem_, resultants);
    const Eigen::Matrix<double, 6, Eigen::Dynamic> accelerations =
        problem_->inertia.accelerationOf(resultants);
    const Eigen::VectorXf on_modes = workOnModes(forces);
    Solution solution{on_modes, {}, 0};
    std::vector<Eigen::VectorXf> on_blocks;  // E^T f
    for (const LocalSystem::Block& block : system.blocks) {
        Eigen::VectorXf own(block.size());
        for (int i = 0; i < block.size(); ++i) {
            const int function = block.functions[i / 3], unknown = 3 * function + i % 3;
            const auto acceleration = accelerations.col(problem_->space->component[function]);
            own[i] =
                static_cast<float>(forces[unknown] + problem_->inertia.forceOn(unknown).dot(acceleration));
        }
        on_blocks.push_back(own);
        solveLower(block.factor.data(), block.size(), block.size(), false, own.data());
        solution.modes -= block.coupling * own;
        solution.local.push_back(std::move(own));
    }
    solveLower(system.modes_factor.data(), modes_.count, modes_.count, false, solution.modes.data());
    solveLower(system.modes_factor.data(), modes_.count, modes_.count, true, solution.modes.data());
    solution.strain_energy_j = 0.5 * double(on_modes.dot(solution.modes));
    bool is_finite = solution.modes.allFinite();
    for (std::size_t b = 0; b < system.blocks.size(); ++b) {
        const LocalSystem::Block& block = system.blocks[b];
        Eigen::VectorXf& local = solution.local[b];
        local -= block.coupling.transpose() * solution.modes;
        solveLower(block.factor.data(), block.size(), block.size(), true, local.data());
        solution.strain_energy_j += 0.5 * double(on_blocks[b].dot(local));
        is_finite = is_finite && local.allFinite();
    }
    if (!is_finite) return Error{"The reduced equations have no finite solution where the loads act."};
    return solution;
}

ReducedResponse ReducedModel::responseOf(const Solution& solution, const LocalSystem& system) const {
    ReducedResponse response{modes_.displacement(solution.modes), solution.strain_energy_j};
    for (std::size_t b = 0; b < system.blocks.size(); ++b) {
        const LocalSystem::Block& block = system.blocks[b];
        for (int i = 0; i < block.size(); i += 3)
            response.unknowns.segment<3>(3L * block.functions[i / 3]) += solution.local[b].segment<3>(i);
    }
    return response;
}

Result<ReducedResponse> ReducedModel::respond(const std::vector<PointForce>& loads) const {
    LocalSystem none;
    return respond(loads, none);
}

Eigen::VectorXf ReducedModel::workOnVibrations(const Eigen::VectorXd& forces) const {
    return vibrations_.shapes.transpose() * workOnModes(forces);
}

StruckModes ReducedModel::struckModes(const std::vector<PointForce>& loads, double contact_s,
                                      LocalSystem& kept) const {
    StruckModes struck;
    if (vibrations_.rates_rad_s.size() == 0) return struck;
    const auto forces = forcesAt(*problem_, loads);
    if (!forces) return struck;
    struck.rates_rad_s = vibrations_.rates_rad_s;
    struck.work = workOnVibrations(forces.value()).array().cast<double>();
    struck.hot_pa = vibrations_.hot_pa.cast<double>();
    // Half a sine wave makes those that are this many times as fast, all of a plate together, swing beyond
    // their static answer by a seventh of what all between some rate and e times that strain the contact.
    constexpr double follows = 3;
    if (contact_s * struck.rates_rad_s.maxCoeff() > follows * pi) return struck;
    const bool is_ready = isDirect() || prepareAbout(local_.around(loads, most_local_), kept);
    if (is_ready) addRitzVectors(beyondModes(forces.value(), struck, kept), struck);
    return struck;
}

BeyondModes ReducedModel::beyondModes(const Eigen::VectorXd& forces, const StruckModes& struck,
                                      const LocalSystem& system) const {
    const auto beyond = [this](const ReducedResponse& response, const Eigen::VectorXf& work) {
        return Eigen::VectorXd(
            (response.unknowns - modes_.displacement(vibrations_.shapes * work)).cast<double>());
    };
    const auto unit = respondInModes(forces, system);
    if (!unit) return {};
    return {beyond(unit.value(), struck.work.matrix().cast<float>()),
            1 - struck.staticEnergy() / unit.value().strain_energy_j,
            [this, mass = ParticleMass(*problem_)](const Eigen::VectorXd& displacement) {
                Eigen::VectorXd momentum = mass.times(displacement);
                Eigen::Matrix<double, 6, Eigen::Dynamic> resultants = problem_->motions.resultants(momentum);
                clearHeld(*problem_, resultants);
                problem_->inertia.balance(momentum, resultants, problem_->motions);
                return momentum;
            },
            [this, beyond, &system](const Eigen::VectorXd& momentum) {
                const auto response = respondInModes(momentum, system);
                return response ? beyond(response.value(), workOnVibrations(momentum)) : Eigen::VectorXd();
            }};
}

Eigen::VectorXf ReducedModel::vibration(const Eigen::ArrayXd& amplitudes) const {
    return modes_.displacement(vibrations_.shapes * amplitudes.matrix().cast<float>());
}

Eigen::VectorXf ReducedModel::vibration(const StruckModes& struck, const Eigen::ArrayXd& amplitudes) const {
    const Eigen::Index of_loads = struck.ritz_vectors.cols();
    Eigen::VectorXf sum = vibration(amplitudes.head(amplitudes.size() - of_loads));
    if (of_loads > 0) sum += struck.ritz_vectors * amplitudes.tail(of_loads).matrix().cast<float>();
    return sum;
}

}  // namespace sherd
