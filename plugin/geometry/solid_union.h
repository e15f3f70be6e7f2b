#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// The closed surface of the union of convex parts, each given by points whose convex hull it is (m). Parts
/// may overlap or touch in faces (CGAL's corefinement, exact constructions); parts that do not touch stay
/// shells of their own. Planes that differ along an axis by less than a millionth of the whole are taken as
/// one, so that single-precision boxes meet. Fails with a sentence if a part is flat or the union touches
/// itself in an edge or a point only.
Result<TriangleMesh> uniteConvexParts(const std::vector<std::vector<Vec3>>& hull_points_of_parts);

}  // namespace sherd
