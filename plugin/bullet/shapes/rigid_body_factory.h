#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <memory>
#include <vector>

#include "core/sampling/voxel_boxes.h"
#include "fracture/breakable_solid.h"

namespace sherd {

/// A collision shape with its children. Members are destroyed in reverse order: the compound before its
/// children.
struct OwnedShape {
    bool disjoint = false;  ///< boxes of the body's own cells: does not overlap the shapes of other fragments
                            ///< of the same break
    std::vector<std::unique_ptr<btCollisionShape>> children;
    std::unique_ptr<btCollisionShape> shape;
    /// Of a whole body: its hulls hold air, more than a tenth of its volume, as those of chairs do, too. Not
    /// of one hull that was asked for: what lies deep in that is carried by nothing.
    bool closes_hollows = false;
    /// Of hulls that stand for a whole body: the vertices of the convex hull of its surface, nearly all of
    /// them; in the body's frame, m.
    std::vector<btVector3> outermost;
};

/// A rigid body with its shape and its motion state.
struct OwnedBody {
    std::shared_ptr<const OwnedShape> shape;  ///< perhaps with other bodies
    std::unique_ptr<btMotionState> motion_state;
    std::unique_ptr<btRigidBody> body;
};

/// The principal axes of a solid at its centre of mass: the frame that Bullet's diagonal inertia asks for.
struct PrincipalFrame {
    btTransform body_from_asset = btTransform::getIdentity();
    Vec3 inertia = Vec3::Zero();  ///< of unit density about the axes, m^5
};
PrincipalFrame principalFrame(const Moments& moments);

/// Of the particle spacing: how far vertices may lie outside the hulls that are made of a solid.
constexpr double shape_tolerance = 0.1;

/// What is to stand for a body in collisions.
struct ShapeChoice {
    ShapeChoice(CollisionShape its_kind) : kind(its_kind) {}
    explicit ShapeChoice(const FractureSettings& settings)
        : kind(settings.collision_shape), most_parts(settings.largest_collision_part_count) {}

    bool operator==(const ShapeChoice& other) const {
        return kind == other.kind && most_parts == other.most_parts;
    }

    CollisionShape kind;
    int most_parts = FractureSettings{}.largest_collision_part_count;  ///< of CollisionShape::automatic
};

/// The wanted shape, in the body's frame; `boxes` are in the asset's. Without boxes it falls back to the hull
/// of the surface, and with a hull that is flat to the boxes.
OwnedShape makeShape(const BreakableSolid& solid, const ShapeChoice& wanted, const std::vector<Box>& boxes,
                     const btTransform& body_from_asset);

/// A rigid body of the solid's mass times `mass_scale`, at the world's origin, not in a world yet. The shape
/// is in its frame.
OwnedBody makeRigidBody(const BreakableSolid& solid, std::shared_ptr<const OwnedShape> shape,
                        double mass_scale);

/// Puts the body to `place` and gives it a motion state of its own, in which its centre of mass is drawn at
/// `drawn`: `m_graphicsWorldTrans` is where to draw the asset.
void placeBody(OwnedBody& owned, const btTransform& place, const btTransform& drawn,
               const btTransform& body_from_asset);

/// Where the motion state of a body draws its centre of mass; without one, where the body is.
btTransform renderedTransform(const btRigidBody& body);

}  // namespace sherd
