#pragma once

#include <LinearMath/btVector3.h>

#include <array>
#include <vector>

#include "bullet/shapes/convex_part.h"

class btPersistentManifold;

namespace sherd {

/// A flat part of ground: what is below it has normal.x < height, in the world, m.
struct Facet {
    btVector3 normal = btVector3(0, 0, 1);
    btScalar height = 0;
    // Its sides: what is over it has inward.x > from for each. A facet without end has sides that are zero.
    std::array<btVector3, 3> inward = {btVector3(0, 0, 0), btVector3(0, 0, 0), btVector3(0, 0, 0)};
    std::array<btScalar, 3> from = {-1, -1, -1};

    btScalar above(const btVector3& place) const { return normal.dot(place) - height; }
    bool isUnder(const btVector3& place) const;
};

/// What a body, or a part of one, lies on.
struct EvenGround {
    btVector3 up = btVector3(0, 0, 1);
    std::vector<Facet> facets;
    bool has_ridges = false;  ///< that reach into a part of that size, where it has no vertices

    /// The highest one under a place; nullptr beside the ground.
    const Facet* under(const btVector3& place) const;
};

/// Ground that is flat or nearly so where a body or a part of one touches it: a static plane, a face of a box
/// that the whole part is over, or triangles of a mesh or a height field that differ by a few degrees, so
/// that no ridge between them matters; these have two sides, and the part is on that of `inside` (world
/// frame). No facets for other ground. `manifold` has a contact. `ground_stood`: where the ground was when
/// that was made; the solver may have moved it since (split impulses). `of_hulls`: also a face of a hull or a
/// cylinder that the whole part is over. Pieces rest on these as Bullet has it.
EvenGround evenGround(const PlacedShape& part, const btPersistentManifold& manifold, bool part_is_a,
                      const btTransform& ground_stood, const btVector3& inside, bool of_hulls);

/// The same for triangles around a part that Bullet may have found no contact with.
EvenGround evenSurface(const PlacedShape& part, const btCollisionObject& surface, const btVector3& inside);

}  // namespace sherd
