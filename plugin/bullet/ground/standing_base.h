#pragma once

#include <LinearMath/btVector3.h>

#include <vector>

namespace sherd {

/// A vertex on which a body may stand.
struct Foot {
    btVector3 place = btVector3(0, 0, 0);   ///< on the surface that collides, m
    btScalar above = 0;                     ///< the ground, m
    btScalar x = 0, y = 0;                  ///< along the ground, from below the centre of mass, m
    btVector3 normal = btVector3(0, 0, 1);  ///< of the ground
};

/// Up to four of some feet: the lowest, and others such that they span a wide base with the centre of mass
/// over it where that can be. `feet` is not empty.
std::vector<Foot> standingBase(const std::vector<Foot>& feet);

}  // namespace sherd
