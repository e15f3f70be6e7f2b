#include "fracture/fragments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sherd {

namespace {

/// Which surface each voxel goes to: that of its particle's label; where a label came apart, the piece with
/// the nearest vertex.
std::vector<int> pieceOfVoxel(const Discretisation& solid, const FragmentLabels& labels,
                              const FragmentSurfaces& surfaces) {
    std::vector<std::vector<int>> pieces_of_label(labels.count);
    for (std::size_t p = 0; p < surfaces.pieces.size(); ++p)
        pieces_of_label[surfaces.pieces[p].label].push_back(static_cast<int>(p));
    std::vector<int> owner(solid.voxels.size(), -1);
    for (std::size_t v = 0; v < solid.voxels.size(); ++v) {
        const int label = labels.of_particle[solid.cells[solid.voxels[v].cell].particle];
        const std::vector<int>& candidates = pieces_of_label[label];
        if (candidates.size() == 1) owner[v] = candidates.front();
        if (candidates.size() < 2) continue;
        const Vec3 centre =
            solid.grid_origin +
            (solid.voxels[v].index.cast<double>().array() + 0.5).matrix().cwiseProduct(solid.cell_size);
        double nearest = std::numeric_limits<double>::infinity();
        for (int p : candidates) {
            for (const Vec3& x : surfaces.pieces[p].mesh.vertices) {
                const double distance = (x - centre).squaredNorm();
                if (distance < nearest) {
                    nearest = distance;
                    owner[v] = p;
                }
            }
        }
    }
    return owner;
}

}  // namespace

int wantedClusters(const BreakableSolid& body, const Damage& damage, const Discretisation& solid,
                   double strain_energy_j) {
    const FractureSettings& fracture = body.settings().fracture;
    if (fracture.fragment_count > 0) return fracture.fragment_count;
    double damaged_volume = 0;
    for (std::size_t i = 0; i < damage.damaged.size(); ++i)
        if (damage.damaged[i]) damaged_volume += solid.particles[i].volume;
    const ClusterBudget budget{fracture.energy_into_cracks * strain_energy_j,
                               body.material().fracture_energy_j_m2, body.wallThickness()};
    const int room = static_cast<int>(std::clamp(damaged_volume / body.smallestFragment(), 1.0, 1e6));
    return std::min({affordableClusters(budget, damaged_volume), room, fracture.largest_fragment_count});
}

double smallestCrackEnergy(const BreakableSolid& body) {
    const double section = body.wallThickness() * body.wallThickness();
    return section * body.material().fracture_energy_j_m2 / body.settings().fracture.energy_into_cracks;
}

std::vector<Fragment> makeFragments(const BreakableSolid& body, const Discretisation& solid,
                                    const FragmentLabels& labels, const FragmentSurfaces& surfaces) {
    const std::vector<int> owner = pieceOfVoxel(solid, labels, surfaces);
    std::vector<Fragment> fragments(surfaces.pieces.size());
    std::vector<char> wanted(solid.voxels.size());
    for (std::size_t p = 0; p < fragments.size(); ++p) {
        fragments[p].body = body.makeFragment(surfaces.pieces[p].mesh);
        for (std::size_t v = 0; v < wanted.size(); ++v) wanted[v] = owner[v] == static_cast<int>(p);
        fragments[p].boxes = mergedBoxes(solid, wanted);
    }
    return fragments;
}

void markDropped(const BreakableSolid& body, std::vector<Fragment>& fragments) {
    const auto volume = [](const Fragment& fragment) { return fragment.body->moments().volume; };
    const auto largest =
        std::max_element(fragments.begin(), fragments.end(),
                         [&](const auto& a, const auto& b) { return volume(a) < volume(b); });
    for (auto fragment = fragments.begin(); fragment != fragments.end(); ++fragment)
        fragment->dropped = fragment != largest && volume(*fragment) < body.smallestFragment();
}

void addConservationErrors(const BreakableSolid& body, BlowOutcome& out) {
    double volume = 0, mass = 0;
    for (const Fragment& fragment : out.fragments) {
        volume += fragment.body->moments().volume;
        mass += fragment.body->mass();
    }
    out.volume_error_rel = std::abs(volume / body.moments().volume - 1);
    out.mass_error_rel = std::abs(mass / body.mass() - 1);
}

Result<std::vector<Box>> collisionBoxes(const BreakableSolid& body) {
    const auto solid = body.discretisation();
    if (!solid) return Error{solid.error()};
    return mergedBoxes(*solid.value(), std::vector<char>(solid.value()->voxels.size(), 1));
}

}  // namespace sherd
