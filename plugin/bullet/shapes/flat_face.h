#pragma once

#include <LinearMath/btVector3.h>

#include <optional>
#include <vector>

#include "bullet/shapes/convex_part.h"

namespace sherd {

/// A plane that bounds one side of a flat face: what is over the face has inward.x >= from.
struct FaceSide {
    btVector3 inward;
    btScalar from;
};

/// A flat face of a convex part, in the world: what is below it has normal.x < height, m.
struct FlatFace {
    btVector3 normal = btVector3(0, 0, 1);
    btScalar height = 0;
    btScalar thickness = BT_LARGE_FLOAT;  ///< of the part below it, m
    std::vector<FaceSide> sides = {};     ///< none: it has no end

    btScalar above(const btVector3& place) const { return normal.dot(place) - height; }
    bool isUnder(const btVector3& place) const;
    /// How far it reaches on all sides of a place on it, m; 0 beside it.
    btScalar roomAround(const btVector3& place) const;
    /// Whether all of another part is over it or below it, none of it beside.
    bool isUnder(const PlacedShape& other) const;
};

/// The face of a plane, a box, a cylinder or a hull that faces a direction, which may be off by a few
/// degrees: Bullet's normals of hulls are. Nothing of other shapes, and where an edge or something round
/// faces there.
std::optional<FlatFace> faceTowards(const PlacedShape& part, const btVector3& direction);

}  // namespace sherd
