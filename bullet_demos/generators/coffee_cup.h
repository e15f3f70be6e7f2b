#pragma once

#include "generators/implicit_mesher.h"

namespace sherd::generators {

/// Measures of a cup that stands on z = 0 around the z axis, its handle along +x. All in m.
struct CupMeasures {
    double outer_radius = 0.040;
    double height = 0.090;
    double wall = 0.005;            ///< of side and bottom
    double rim_rounding = 0.0024;   ///< of both edges of the rim: nearly half the wall
    double foot_rounding = 0.007;   ///< of the outer edge at the bottom
    double floor_rounding = 0.006;  ///< of the inner edge at the bottom

    double handle_reach = 0.0635;  ///< of the handle's centre line from the axis
    double handle_bottom = 0.021;  ///< height of the centre line where it leaves the wall, below
    double handle_top = 0.073;     ///< and above
    double handle_bend = 0.022;    ///< radius of the centre line's two bends
    double handle_thickness = 0.0076;
    double handle_width = 0.0106;
    double handle_fillet = 0.0035;  ///< where it meets the wall
};

/// Signed distance to the cup's surface, m, negative in the material.
double cupDistance(const CupMeasures& cup, const Eigen::Vector3d& point);

ImplicitSolid coffeeCup(const CupMeasures& cup);

}  // namespace sherd::generators
