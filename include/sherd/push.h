#pragma once

#include <LinearMath/btVector3.h>

namespace sherd {

/// A push that a program gives to a body: a hit of a bullet, of a hammer, of a blast. World frame.
struct Push {
    /// On the surface, as a ray test finds it, m. The nearest place that faces the push is hit; the way to it
    /// is not looked at, so a point far from the surface is refused.
    btVector3 point = btVector3(0, 0, 0);
    /// On the body, all of it: 4 N s make a shard of 5 g 800 m/s fast. What strikes at a speed v gives a free
    /// body of mass m no more than m v if it is stopped there.
    btVector3 impulse_n_s = btVector3(0, 0, 0);
    double patch_radius_m = 0;  ///< of the part of the surface that is hit; 0: as small as the settings allow
    /// Of what strikes, m/s: the push then brings the energy J v / 2, as a striker that is stopped does (a
    /// hammer of 0.5 kg at 8 m/s: 4 N s, 16 J). All of it bends the body: none goes into a hole or into the
    /// striker, so give a bullet, which spends most of its energy there, a fraction of its speed (20 to 50).
    /// 0: not known, and the energy is what the impulse alone gives to the body, J^2 / 2 m; a lower speed
    /// than J / m counts as that.
    double speed_m_s = 0;
};

}  // namespace sherd
