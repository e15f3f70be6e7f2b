#pragma once

#include "core/stress/elasticity.h"

namespace sherd {

/// Places side by side, each in a lane of its own: what is done to one is done to all.
struct PlaceLanes {
    static constexpr int count = 8;
    using Lane = double[count];
    Lane x[3];  ///< m
};

/// Stress at places side by side, Pa.
struct StressLanes {
    using Lane = PlaceLanes::Lane;
    Lane s[6];  ///< in the order of a SymmetricTensor

    SymmetricTensor at(int lane) const {
        SymmetricTensor stress;
        for (int i = 0; i < 6; ++i) stress[i] = s[i][lane];
        return stress;
    }
};

/// A surface at places side by side.
struct SurfaceLanes {
    using Lane = PlaceLanes::Lane;
    Lane normal[3];       ///< outward, of any length
    Lane traction_pa[3];  ///< that acts on it
    Lane is_known;        ///< 1 where it is, 0 where there is no surface or what acts on it is not known
};

/// Hooke's law: `gradient` is that of the displacement, component by direction.
void stressOf(const Elasticity& elasticity, const PlaceLanes::Lane (&gradient)[3][3], StressLanes& stress);

/// withTraction where the surface is known.
void applyTraction(const SurfaceLanes& surface, const Elasticity& elasticity, StressLanes& stress);

/// Bounds of the principal stresses, see boundPrincipal.
void boundPrincipal(const StressLanes& stress, PlaceLanes::Lane& smallest_pa, PlaceLanes::Lane& largest_pa);

}  // namespace sherd
