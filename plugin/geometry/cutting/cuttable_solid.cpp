#include "geometry/cutting/cuttable_solid.h"

#include "geometry/cutting/lattice_spacing.h"

namespace sherd {

CuttableSolid::CuttableSolid(const TriangleMesh& mesh, const Discretisation& solid)
    : surface_(mesh), reach_(reachOfParticles(solid)) {
    if (solid.particles.empty() || mesh.triangles.empty()) return;
    const double spacing = latticeSpacing(mesh, solid.particles.front().spacing, most_lattice_nodes);
    usual_layout_ = std::make_shared<const LatticeLayout>(layLattice(mesh, solid, spacing));
}

std::shared_ptr<const LatticeLayout> CuttableSolid::layout(const Discretisation& solid,
                                                           double spacing_m) const {
    if (usual_layout_ && usual_layout_->grid.spacing == spacing_m) return usual_layout_;
    return std::make_shared<const LatticeLayout>(layLattice(surface_.mesh(), solid, spacing_m));
}

}  // namespace sherd
