#pragma once

#include "core/archive/finite.h"
#include "core/mlpg/splines/monomials.h"
#include "core/mlpg/splines/spline_motions.h"
#include "core/mlpg/splines/spline_problem.h"
#include "core/sampling/archive.h"

namespace sherd {

template <class Archive>
void SplineSpace::archiveFields(Archive& archive, const CellParts& solid) {
    auto& [space_degree, components, components_of_part, raw, raw_functions, functions, greville, highest,
           component_of, ties] = *this;
    static_cast<void>(greville);  // follow from the highest cells
    auto& [raw_of_function, starts, terms] = ties;
    static_cast<void>(raw_of_function);  // was for making the space
    archiveAll(archive, space_degree, components, raw, functions);
    archive.require(1 <= space_degree && space_degree <= largest_spline_degree && components > 0 &&
                    raw >= 0 && functions >= 0 && functions < std::numeric_limits<int>::max() / 3);
    archiveIndices(archive, components_of_part, components);
    archiveIndices(archive, raw_functions, raw);
    const Eigen::Vector3i lattice = solid.count.array() + space_degree;
    archiveList(archive, highest, 3, [&](Eigen::Vector3i& cell) {
        for (int d = 0; d < 3; ++d) archiveIndex(archive, cell[d], lattice[d]);
    });
    archiveIndices(archive, component_of, components);

    const int end = functions;
    archiveList(archive, terms, sizeof(double) + 1, [&](SplineTies::Term& term) {
        archiveIndex(archive, term.function, end);
        sherd::archive(archive, term.factor);
    });
    archiveStarts(archive, starts, static_cast<std::size_t>(raw), terms.size());

    const auto function_total = static_cast<std::size_t>(end);
    archive.require(components_of_part.size() == solid.parts.size() &&
                    raw_functions.size() == solid.parts.size() && highest.size() == function_total &&
                    component_of.size() == function_total);
    for (const std::vector<int>& of_part : raw_functions)
        archive.require(of_part.size() == static_cast<std::size_t>(perPart()));
    if constexpr (Archive::reads) findGrevillePoints(solid);
}

template <class Archive>
void archiveNumbers(Archive& archive, Eigen::Index rows, Eigen::Index columns, bool in_float,
                    Eigen::MatrixXd& matrix) {
    // A list is read no longer than the file is; a matrix of given size would be.
    std::vector<double> numbers(matrix.data(), matrix.data() + matrix.size());
    std::vector<float> rounded(numbers.begin(), in_float ? numbers.end() : numbers.begin());
    if (in_float) {
        sherd::archive(archive, rounded);
        numbers.assign(rounded.begin(), rounded.end());
    } else {
        sherd::archive(archive, numbers);
    }
    archive.require(numbers.size() == static_cast<std::size_t>(rows * columns) && areFinite(numbers));
    if (Archive::reads && archive.good())
        matrix = Eigen::Map<const Eigen::MatrixXd>(numbers.data(), rows, columns);
}

template <class Archive>
void VolumetricProjection::archiveFields(Archive& archive, const CellParts& solid, const SplineSpace& space) {
    degree_ = space.degree;
    const auto monomials = static_cast<Eigen::Index>(monomialsOf(degree_ - 1).size());
    const auto part_count = static_cast<int>(solid.parts.size());
    std::size_t parts_in_all = 0;
    archiveList(archive, cells_, sizeof(Vec3), [&](MacroCell& cell) {
        auto& [parts, functions, centre, modes, rates] = cell;
        archiveIndices(archive, parts, part_count);
        parts_in_all += parts.size();
        if (Archive::reads && archive.good()) functions = functionsOf(space, parts);
        auto mode_count = static_cast<int>(modes.rows());
        archiveIndex(archive, mode_count, static_cast<int>(monomials) + 1);
        sherd::archive(archive, centre);
        archive.require(areFinite(centre));
        if (!archive.good()) return;
        archiveNumbers(archive, mode_count, monomials, false, modes);
        const auto coefficients = static_cast<Eigen::Index>(3 * functions.size());
        archiveNumbers(archive, mode_count, coefficients, true, rates);  // stress is read in float
    });
    archive.require(parts_in_all == solid.parts.size());
    if (Archive::reads && archive.good()) findPlaces(solid);
}

/// The problem of a solid that is not damaged, as loads and displacements need it: springs of supports, which
/// only its stiffness holds, are left out. Reads it if there is no `written`.
template <class Archive>
std::shared_ptr<const SplineProblem> archiveProblem(Archive& archive,
                                                    const std::shared_ptr<const Discretisation>& sampling,
                                                    const Material& material, const SplineProblem* written) {
    SplineSpace own_space;
    std::vector<Moments> of_components;
    std::vector<char> is_held;
    Eigen::Matrix4Xd about_centres;
    VolumetricProjection projection;
    if (written) {
        const auto& [solid, elasticity, density, shares, space, motions, supports, held, inertia_moments,
                     inertia, own_projection] = *written;
        static_cast<void>(solid), static_cast<void>(elasticity), static_cast<void>(density);
        static_cast<void>(supports), static_cast<void>(inertia);
        archive.require(shares.empty());
        own_space = *space;
        of_components = motions.moments;
        is_held = held;
        about_centres = inertia_moments;
        if (own_projection) projection = *own_projection;
    }
    own_space.archiveFields(archive, sampling->parts);
    archiveAll(archive, of_components, is_held, about_centres);
    const auto component_count = static_cast<std::size_t>(own_space.component_count);
    archive.require(of_components.size() == component_count && is_held.size() == component_count &&
                    about_centres.cols() == own_space.function_count);
    const Elasticity elasticity(material);
    if (isNearlyIncompressible(elasticity)) projection.archiveFields(archive, sampling->parts, own_space);
    if (!Archive::reads || !archive.good()) return nullptr;

    const auto space = std::make_shared<const SplineSpace>(std::move(own_space));
    RigidMotions motions = splineMotions(*space, std::move(of_components));
    InertiaRelief inertia = splineInertia(about_centres, motions);
    std::shared_ptr<const VolumetricProjection> kept_projection;
    if (isNearlyIncompressible(elasticity))
        kept_projection = std::make_shared<const VolumetricProjection>(std::move(projection));
    return std::make_shared<const SplineProblem>(SplineProblem{sampling,
                                                               elasticity,
                                                               material.density_kg_m3,
                                                               {},
                                                               space,
                                                               std::move(motions),
                                                               {},
                                                               std::move(is_held),
                                                               std::move(about_centres),
                                                               std::move(inertia),
                                                               std::move(kept_projection)});
}

}  // namespace sherd
