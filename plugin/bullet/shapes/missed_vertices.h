#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <vector>

namespace sherd {

/// Which vertices count beside those inside the other body.
struct WantedVertices {
    btScalar reach = 0;  ///< those that are no further than that outside the other body, m
    /// Of a body of several parts on something flat, also those of parts that the manifold is not of.
    bool of_all_parts = false;
    /// What is over a face of a hull or a cylinder is looked for as over a plane or a box.
    bool on_hulls = false;
};

/// Vertices of boxes and hulls that overlap the other body and that its manifold lacks, as contact points
/// without impulse. A manifold keeps one point of those closer together than its breaking threshold. A hull
/// gets one point a step, a body on a plane the deepest vertex and some of those around it. Of vertices that
/// touch at the same time some may be missing, and which ones depends on the step. Looked for are those in a
/// plane or a box, and those near a point that there is. `stood_a` and `stood_b`: where the bodies stood when
/// the manifold was made; the solver may have moved them since (split impulses).
std::vector<btManifoldPoint> missedVertices(const btPersistentManifold& manifold, const btTransform& stood_a,
                                            const btTransform& stood_b, const WantedVertices& wanted);

/// A face that lands flat touches with all its vertices at once; the one point that a manifold gets for it
/// may be anywhere between them. Whether `point` is one of these: at least three of the vertices are no less
/// deep than it, and they lie all around it. `lands_on_face`: the body lands on the face of a box or on a
/// plane, where it may also be between two ends of an edge; what is round touches an edge in between.
bool isBetween(const btManifoldPoint& point, const std::vector<btManifoldPoint>& vertices,
               bool lands_on_face = false);

}  // namespace sherd
