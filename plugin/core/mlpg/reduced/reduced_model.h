#pragma once

#include <sherd/result.h>

#include <memory>
#include <utility>
#include <vector>

#include "core/mlpg/reduced/compliance_matrix.h"
#include "core/mlpg/reduced/local_functions.h"
#include "core/mlpg/reduced/packed_stiffness.h"
#include "core/mlpg/reduced/proper_modes.h"
#include "core/mlpg/reduced/ritz_vectors.h"
#include "core/mlpg/reduced/vibration_modes.h"
#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

/// How large a reduced model may be.
struct ReducedModelLimits {
    int patches = 300;  ///< with three unit loads each
    int modes = 128;
    int local_functions = 300;  ///< about the loads
    /// Solids of no more unknowns are answered by their compliance matrix, of up to 8 MB.
    int direct_unknowns = 1400;
};

/// What answers a blow without a factor. The displacement is a combination of proper modes plus any
/// displacement of the functions about the loads, where modes are too coarse. One Galerkin solve finds both,
///     [ I      V^T K E ] [c]   [V^T f]
///     [ E^T K V   E^T K E ] [d] = [E^T f],      u = V c + E d,
/// E being the unit vectors of the functions about the loads: some hundreds of unknowns, solved first.
/// Compare Barbic, Zhao, Subspace self-collision culling (2010), and the static correction of component mode
/// synthesis (Craig, Bampton 1968). A small solid needs no modes: its whole compliance matrix is kept. A
/// contact squeezes a compact solid, such as a ball: its tension is some percent of the pressure, and so is
/// what modes lack there, which some rounds on the whole matrix find then.
class ReducedModel {
  public:
    /// `stiffness` is that of the problem; `unit` is what loads on `limits.patches` patches do.
    static Result<ReducedModel> make(std::shared_ptr<const SplineProblem> problem,
                                     const BlockMatrix& stiffness, const UnitResponses& unit,
                                     const ReducedModelLimits& limits = {});

    /// Of a solid with no more unknowns than `direct_unknowns`: by its compliance matrix. `pinned`: unknowns
    /// that the factor holds.
    static Result<ReducedModel> makeDirect(std::shared_ptr<const SplineProblem> problem,
                                           const SparseSolver& factor, const std::vector<int>& pinned,
                                           const UnitResponses& unit, const Progress& progress = {});

    /// Of parts that were made before.
    ReducedModel(std::shared_ptr<const SplineProblem> problem, PackedStiffness stiffness, ProperModes modes,
                 VibrationModes vibrations, const ReducedModelLimits& limits);
    ReducedModel(std::shared_ptr<const SplineProblem> problem, ComplianceMatrix compliance, ProperModes modes,
                 VibrationModes vibrations);

    /// The equations of the functions about loads, in blocks that the stiffness does not join: only the modes
    /// do. What is left to them, I - sum of V^T K E (E^T K E)^-1 E^T K V, is small. Loads at the same places
    /// need no other.
    struct LocalSystem {
        /// Of functions that are joined.
        struct Block {
            std::vector<int> functions;  ///< ascending
            Eigen::MatrixXf factor;      ///< L, lower, of E^T K E
            Eigen::MatrixXf coupling;    ///< V^T K E L^-T
            Eigen::MatrixXf taken;       ///< lower, what it takes from the modes: - coupling coupling^T
            float stiffening = 0;        ///< of the diagonal of E^T K E

            int size() const { return 3 * static_cast<int>(functions.size()); }
        };

        std::vector<int> functions;  ///< ascending
        std::vector<Block> blocks;
        Eigen::MatrixXf modes_factor;  ///< lower, of what is left to the modes
    };

    /// The displacement under point forces and the rigid acceleration that balances them. An error says that
    /// the full solve is needed.
    Result<ReducedResponse> respond(const std::vector<PointForce>& loads) const;
    /// The same, with what is kept of the loads before.
    Result<ReducedResponse> respond(const std::vector<PointForce>& loads, LocalSystem& kept) const;
    /// The strain energy alone, J.
    Result<double> strainEnergy(const std::vector<PointForce>& loads, LocalSystem& kept) const;
    /// The displacement under forces at the unknowns (N), with the functions of a system that was made for
    /// some loads.
    Result<ReducedResponse> respond(const Eigen::VectorXd& forces, const LocalSystem& system) const;

    /// The vibrations under point forces of a contact that lasts `contact_s` at least: those of the body,
    /// and if they are too slow for it, those of the loads (addRitzVectors). None if the forces are not on
    /// the solid, or nothing is known of its vibrations.
    StruckModes struckModes(const std::vector<PointForce>& loads, double contact_s, LocalSystem& kept) const;
    /// The displacement of vibrations with these amplitudes, the first of StruckModes, #unknowns.
    Eigen::VectorXf vibration(const Eigen::ArrayXd& amplitudes) const;
    /// Of all of them.
    Eigen::VectorXf vibration(const StruckModes& struck, const Eigen::ArrayXd& amplitudes) const;

    const SplineProblem& problem() const { return *problem_; }
    /// See VibrationModes.
    void keepHotPlaces(Eigen::MatrixXf hot_pa) { vibrations_.hot_pa = std::move(hot_pa); }

    const PackedStiffness& stiffness() const { return stiffness_; }
    const ProperModes& modes() const { return modes_; }
    const VibrationModes& vibrations() const { return vibrations_; }
    const ComplianceMatrix& compliance() const { return compliance_; }
    /// Whether the compliance matrix answers: then modes are for vibrations alone, and there may be none.
    bool isDirect() const { return compliance_.entries.size() > 0; }
    const ReducedModelLimits& limits() const { return limits_; }

  private:
    bool coversAComponent(const std::vector<int>& functions) const;
    double roundingOfModes(const BlockMatrix& stiffness) const;
    bool factorBlock(LocalSystem::Block& block) const;
    bool addBlock(std::vector<int> functions, float stiffening, LocalSystem& before,
                  LocalSystem& system) const;
    bool factor(float stiffening, LocalSystem& before, LocalSystem& system) const;
    Status prepareAbout(std::vector<int> functions, LocalSystem& kept) const;
    /// What solves the equations.
    struct Solution {
        Eigen::VectorXf modes;               ///< c
        std::vector<Eigen::VectorXf> local;  ///< d, per block
        double strain_energy_j = 0;
    };
    Eigen::VectorXf workOnModes(const Eigen::VectorXd& forces) const;
    Eigen::VectorXf workOnVibrations(const Eigen::VectorXd& forces) const;
    BeyondModes beyondModes(const Eigen::VectorXd& forces, const StruckModes& struck,
                            const LocalSystem& system) const;
    Result<Eigen::VectorXd> forcesOf(const std::vector<PointForce>& loads, LocalSystem& kept) const;
    Result<Solution> solve(const Eigen::VectorXd& forces, const LocalSystem& system) const;
    Result<ReducedResponse> respondInModes(const Eigen::VectorXd& forces, const LocalSystem& system) const;
    void refine(const Eigen::VectorXd& forces, ReducedResponse& response) const;
    ReducedResponse responseOf(const Solution& solution, const LocalSystem& system) const;

    std::shared_ptr<const SplineProblem> problem_;
    PackedStiffness stiffness_;
    ProperModes modes_;
    VibrationModes vibrations_;
    ComplianceMatrix compliance_;
    LocalFunctions local_;
    ReducedModelLimits limits_;
    std::vector<int> functions_of_component_;
    int most_local_ = 0;
    int refinements_ = 0;  // rounds
};

}  // namespace sherd
