#include "geometry/cutting/cut_fragments.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "geometry/cutting/approximate_fragments.h"
#include "geometry/cutting/carry_attributes.h"
#include "geometry/cutting/crack_nudging.h"
#include "geometry/cutting/crack_roughness.h"
#include "geometry/cutting/crack_smoothing.h"
#include "geometry/cutting/cut_faces.h"
#include "geometry/cutting/lattice_building.h"
#include "geometry/cutting/lattice_spacing.h"
#include "geometry/cutting/marching_tetrahedra.h"
#include "geometry/cutting/pieces.h"
#include "geometry/cutting/plane_cuts.h"

namespace sherd {

namespace {

constexpr double volume_tolerance = 1e-9;
constexpr int most_nudges = 8;  // rounds of moving single crack triangles before another lattice is tried

Status checkInput(const CuttableSurface& surface, const Discretisation& solid, const FragmentLabels& labels) {
    if (surface.mesh().triangles.empty()) return Error{"The surface to be cut has no triangles."};
    if (labels.of_particle.size() != solid.particles.size() || solid.particles.empty())
        return Error{"There is not one fragment label for each particle."};
    for (int label : labels.of_particle)
        if (label < 0 || label >= labels.count) return Error{"A fragment label is out of range."};
    if (!surface.isClosed())
        return Error{
            "The surface to be cut is not closed and oriented; check it before it is made breakable."};
    return success();
}

// Cuts; as long as cracks pass too near to a vertex or an edge of the surface, moves them a little and cuts
// again.
CutAttempt cutWithNudges(const CuttableSurface& surface, const LabelLattice& lattice, CrackComplex& crack,
                         std::uint64_t seed) {
    CutAttempt attempt = cutFaces(surface, lattice, crack);
    for (int nudge = 0; nudge < most_nudges && !attempt.troubled.empty(); ++nudge) {
        for (int triangle : attempt.troubled) nudgeTriangle(crack, lattice, triangle, seed, nudge);
        attempt = cutFaces(surface, lattice, crack);
    }
    if (!attempt.troubled.empty()) attempt.failure = "a crack keeps touching an edge of the surface";
    return attempt;
}

/// The pieces of a cut; `why` says why there are none.
std::optional<FragmentSurfaces> piecesOf(const TriangleMesh& surface, const CutFaces& faces,
                                         const Discretisation& solid, const FragmentLabels& labels,
                                         const CutSettings& settings, std::string& why) {
    auto pieces = assemblePieces(surface, faces, solid, labels, settings.pieces);
    why = pieces ? "the volumes of the fragments do not add up" : pieces.error();
    if (!pieces || !(std::abs(volumeRatio(surface, pieces.value()) - 1) <= volume_tolerance)) return {};
    return FragmentSurfaces{std::move(pieces).value(), {}};
}

struct LatticeChoice {
    double spacing_m;
    std::uint64_t seed;
};

std::optional<FragmentSurfaces> tryLattice(const CuttableSolid& cuttable, const Discretisation& solid,
                                           const FragmentLabels& labels, const LatticeChoice& choice,
                                           const CutSettings& settings, std::string& why) {
    const TriangleMesh& surface = cuttable.surface().mesh();
    const LabelLattice lattice =
        buildLabelLattice(cuttable.layout(choice.spacing_m), solid, cuttable.reach(), labels, choice.seed);
    CrackComplex crack = buildCrackComplex(lattice);
    smoothCracks(crack, lattice, smoothing_steps);
    if (settings.roughness > 0)
        roughenCracks(crack, lattice, settings.roughness * solid.spacing, choice.seed);
    const CutAttempt attempt = cutWithNudges(cuttable.surface(), lattice, crack, choice.seed);
    if (attempt.failure) {
        why = attempt.failure;
        return {};
    }
    return piecesOf(surface, attempt.faces, solid, labels, settings, why);
}

Result<FragmentSurfaces> cutOrThrow(const CuttableSolid& cuttable, const Discretisation& solid,
                                    const FragmentLabels& labels, const CutSettings& settings) {
    if (const Status checked = checkInput(cuttable.surface(), solid, labels); !checked)
        return Error{checked.error()};
    const TriangleMesh& surface = cuttable.surface().mesh();
    std::string why = "no lattice was tried";
    if (arePlanesEnough(labels) && settings.roughness == 0)
        if (const auto faces = cutByPlanes(cuttable.surface(), solid, labels))
            if (auto cut = piecesOf(surface, *faces, solid, labels, settings, why)) return std::move(*cut);
    const double spacing = latticeSpacing(surface, spacingAtBorders(solid, labels), most_lattice_nodes);
    for (int k = 0; k < settings.lattices; ++k) {
        // Another jitter each time, and from the third lattice on a coarser one, whose faces are larger and
        // fewer.
        const double coarser = 1 + 0.15 * std::max(0, k - 1);
        const LatticeChoice lattice = {spacing * coarser,
                                       settings.seed + 0x51ed2701ULL * static_cast<std::uint64_t>(k)};
        auto cut = tryLattice(cuttable, solid, labels, lattice, settings, why);
        if (!cut) continue;
        if (k > 1)
            cut->notes.push_back("Crack faces are " + std::to_string(static_cast<int>(100 * coarser - 99.5)) +
                                 " % coarser than usual, since finer ones could not be cut cleanly.");
        return std::move(*cut);
    }
    return approximateFragments(surface, cuttable.reach(), solid, labels, settings, why);
}

}  // namespace

Result<FragmentSurfaces> cutFragments(const CuttableSolid& cuttable, const Discretisation& solid,
                                      const FragmentLabels& labels, const CutSettings& settings) {
    try {
        auto cut = cutOrThrow(cuttable, solid, labels, settings);
        if (!cut) return Error{cut.error()};
        FragmentSurfaces fragments = std::move(cut).value();
        carryAttributes(cuttable.surface().mesh(), fragments.pieces);
        return fragments;
    } catch (const std::exception& e) {
        return Error{std::string("The fragments' surfaces could not be cut (") + e.what() +
                     "); the body stays whole."};
    }
}

Result<FragmentSurfaces> cutFragments(const TriangleMesh& surface, const Discretisation& solid,
                                      const FragmentLabels& labels, const CutSettings& settings) {
    return cutFragments(CuttableSolid(surface, solid), solid, labels, settings);
}

}  // namespace sherd
