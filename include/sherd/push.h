#pragma once

#include <LinearMath/btVector3.h>

namespace sherd {

/// A push that a program gives to a body: a hit of a bullet, of a hammer, of a blast. World frame.
struct Push {
    btVector3 point = btVector3(0, 0, 0);  ///< m; the nearest place of the surface that faces the push is hit
    btVector3 impulse_n_s = btVector3(0, 0, 0);  ///< on the body
    double patch_radius_m = 0;  ///< of the part of the surface that is hit; 0: as small as the settings allow
    /// Of what strikes, m/s: the push then brings the energy J v / 2, as a striker that is stopped does (a
    /// bullet of 8 g at 400 m/s: 3.2 N s, 640 J). 0: not known, and the energy is what the impulse alone
    /// gives to the body, J^2 / 2 m; a lower speed than J / m counts as that.
    double speed_m_s = 0;
};

}  // namespace sherd
