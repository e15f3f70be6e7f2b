#pragma once

#include "generators/implicit_mesher.h"

namespace sherd::generators {

/// A round cone or a flat tapered strip: centres and radii of its two rounded ends, m.
struct Taper {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::UnitX();
    double from_radius = 0.01, to_radius = 0.01;
};

/// Measures of a toy aeroplane that flies along +x with z up. The wings and the tail are mirrored at y = 0.
/// All in m. Wing and tail are not swept back more than they taper, so that their trailing edge has no notch
/// in the middle.
struct PlaneMeasures {
    Taper front{{0.02, 0, 0}, {0.115, 0, -0.002}, 0.030, 0.018};
    Taper rear{{0.02, 0, 0}, {-0.130, 0, 0.006}, 0.030, 0.012};
    Taper canopy{{0.050, 0, 0.022}, {0.004, 0, 0.024}, 0.014, 0.013};
    Taper wing{{0.030, 0, -0.008}, {0.018, 0.150, -0.008}, 0.040, 0.024};
    Taper tail{{-0.122, 0, 0.006}, {-0.127, 0.060, 0.006}, 0.023, 0.014};
    Taper fin{{-0.118, 0, 0.008}, {-0.133, 0, 0.062}, 0.022, 0.013};
    double wing_thickness = 0.011;
    double tail_thickness = 0.0085;  ///< and of the fin
    double fillet = 0.006;           ///< where parts meet
};

/// One closed solid: fuselage, canopy, wings, tail and fin.
ImplicitSolid plane(const PlaneMeasures& measures);

}  // namespace sherd::generators
