#pragma once

#include <sherd/stress_field.h>
#include <sherd/surface_region.h>

#include <vector>

#include "core/loads/region_parts.h"
#include "core/stress/elasticity.h"
#include "fracture/breakable_solid.h"
#include "geometry/surface_feet.h"

namespace sherd {

/// A load, and the area that it is spread over.
struct PlacedLoad {
    SurfaceLoad load;
    double area_m2 = 0;
};

/// The tractions that act on a body's surface; those on supports are not known.
class SurfaceTractions {
  public:
    SurfaceTractions(const BreakableSolid& body, const std::vector<PlacedLoad>& loads);

    /// The stress at a foot on the surface, made to carry the traction there; `raw` where there is no normal,
    /// and on supports.
    SymmetricTensor imposedOn(const SymmetricTensor& raw, const SurfaceFoot& foot) const;

    /// Imposes them on the stresses at the surface points of the body's sampling.
    void imposeOnSurface(std::vector<SymmetricTensor>& surface) const;

  private:
    const BreakableSolid& solid_;
    Elasticity elasticity_;
    std::vector<PlacedLoad> loads_;
    std::vector<RegionOnSurface> load_regions_, support_regions_;
};

/// Distance from the surface below which a foot near an edge has no normal, m.
double edgeTolerance(const BreakableSolid& body);

}  // namespace sherd
