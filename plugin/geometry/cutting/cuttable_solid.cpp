#include "geometry/cutting/cuttable_solid.h"

#include "geometry/cutting/lattice_spacing.h"

namespace sherd {

CuttableSolid::CuttableSolid(const TriangleMesh& mesh, const Discretisation& solid)
    : surface_(mesh), solid_(solid), of_lattices_(std::make_unique<OfLattices>()) {
    if (solid.particles.empty() || mesh.triangles.empty()) return;
    usual_spacing_m_ = latticeSpacing(mesh, solid.particles.front().spacing, most_lattice_nodes);
}

const ParticleReach& CuttableSolid::reach() const {
    return of_lattices_->reach.get([&] { return reachOfParticles(solid_); });
}

std::shared_ptr<const LatticeLayout> CuttableSolid::layout(double spacing_m) const {
    const auto make = [&] {
        return std::make_shared<const LatticeLayout>(layLattice(surface_.mesh(), solid_, spacing_m));
    };
    return spacing_m == usual_spacing_m_ ? of_lattices_->usual_layout.get(make) : make();
}

}  // namespace sherd
