#pragma once

#include <memory>

#include "geometry/cutting/cuttable_surface.h"
#include "geometry/cutting/lattice_layout.h"
#include "geometry/cutting/particle_reach.h"

namespace sherd {

/// A sampled solid with what every cut needs of it and none changes.
class CuttableSolid {
  public:
    /// The surface has to outlive this.
    CuttableSolid(const TriangleMesh& mesh, const Discretisation& solid);

    const CuttableSurface& surface() const { return surface_; }
    const ParticleReach& reach() const { return reach_; }
    /// That of a lattice; kept for the spacing that nearly all cuts have. `solid` is the one it was made of.
    std::shared_ptr<const LatticeLayout> layout(const Discretisation& solid, double spacing_m) const;

  private:
    CuttableSurface surface_;
    ParticleReach reach_;
    std::shared_ptr<const LatticeLayout> usual_layout_;
};

}  // namespace sherd
