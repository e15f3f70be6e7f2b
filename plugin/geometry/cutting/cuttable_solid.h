#pragma once

#include <memory>

#include "core/numerics/made_once.h"
#include "geometry/cutting/cuttable_surface.h"
#include "geometry/cutting/lattice_layout.h"
#include "geometry/cutting/particle_reach.h"

namespace sherd {

/// A sampled solid with what every cut needs of it and none changes.
class CuttableSolid {
  public:
    /// The surface and the solid have to outlive this.
    CuttableSolid(const TriangleMesh& mesh, const Discretisation& solid);

    const CuttableSurface& surface() const { return surface_; }
    /// What only a lattice needs is made at the first call.
    const ParticleReach& reach() const;
    /// That of a lattice; kept for the spacing that nearly all cuts have.
    std::shared_ptr<const LatticeLayout> layout(double spacing_m) const;

  private:
    struct OfLattices {
        MadeOnce<ParticleReach> reach;
        MadeOnce<std::shared_ptr<const LatticeLayout>> usual_layout;
    };

    CuttableSurface surface_;
    const Discretisation& solid_;
    double usual_spacing_m_ = 0;
    std::unique_ptr<OfLattices> of_lattices_;
};

}  // namespace sherd
