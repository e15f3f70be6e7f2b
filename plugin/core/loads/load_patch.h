#pragma once

#include <sherd/types.h>

#include <array>
#include <vector>

#include "core/loads/surface_tree.h"

namespace sherd {

/// Where a contact point of the collision shape lies on the true surface.
struct SurfaceSpot {
    Vec3 point = Vec3::Zero();  ///< nearest point of the surface, m
    int triangle = -1;
};

/// Nearest point on the triangles that face the push (their outward normals are against it), or on all
/// triangles if none does.
SurfaceSpot nearestSurfacePoint(const SurfaceTree& tree, const Vec3& point, const Vec3& push);

/// The corner of a triangle facing the push that is nearest to `point`, of those that lie before the plane
/// through `point` at right angles to the push, or at most `gap` (m) behind it. Without any, no triangle.
SurfaceSpot touchedByAPlane(const SurfaceTree& tree, const Vec3& point, const Vec3& push, double gap);

/// Radius of curvature with which the surface meets a flat partner at `spot`, m: that of the paraboloid whose
/// cap of height `depth` covers as much of a plane across the push, A = 2 pi R depth, as the part of the
/// surface within `reach` of the spot and within `depth` of the outermost point there against the push. Faces
/// give a large radius, edges and corners a small one.
double contactRadius(const SurfaceTree& tree, const Vec3& spot, const Vec3& push, double reach, double depth);

/// A direction, rounded: of however many triangles a patch is made, their normals are few of these.
using RoundedNormal = std::array<long, 3>;
RoundedNormal rounded(const Vec3& normal);

/// Cosine between the normals of neighbours on one smooth face, of coarse meshes too.
constexpr double on_one_face = 0.8;

/// A part of the surface that a contact presses on.
struct PatchPart {
    Vec3 centre = Vec3::Zero();  ///< m
    Vec3 normal = Vec3::Zero();  ///< outward, unit
    double weight_m2 = 0;        ///< area times the traction relative to that in the middle of the contact
    double pressed = 1;  ///< traction over what there were if its face were the one that faces the push most
};

/// The surface within `radius` of `spot` under a traction with the profile of a contact: what faces the push,
/// and what goes on from there smoothly, since a push that grazes a round surface presses on both sides of
/// the spot. `length`: of the parts at most, in radii.
std::vector<PatchPart> partsOfPatch(const SurfaceTree& tree, const SurfaceSpot& spot, const Vec3& push,
                                    double radius, double length);

/// A piece of the surface.
struct PieceNearby {
    Vec3 centre = Vec3::Zero();  ///< m
    Vec3 area = Vec3::Zero();    ///< m^2, outward
};

/// The surface within `reach` of a point in pieces that are no longer than `size` (m) within `close` of it,
/// and further away as much longer as they are further.
std::vector<PieceNearby> surfaceAround(const SurfaceTree& tree, const Vec3& point, double reach, double close,
                                       double size);

/// Where a ray from a point inside leaves the solid; no triangle if it does not.
SurfaceSpot wayOut(const SurfaceTree& tree, const Vec3& from, const Vec3& direction);

/// Spreads a force over the parts of a patch. Returns quadrature points whose forces add up to `force`; one
/// at the spot if there are no parts.
std::vector<PointForce> spreadForce(const std::vector<PatchPart>& parts, const SurfaceSpot& spot,
                                    const Vec3& force);

}  // namespace sherd
