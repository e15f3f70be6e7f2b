#pragma once

#include <algorithm>

#include "core/numerics/mesh_measures.h"

namespace sherd {

/// An order of points: by x, then y, then z.
inline bool precedes(const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// The corners of a triangle in that order: the same for triangles of other meshes at the same place,
/// whichever way they face.
inline TriangleCorners sortedCorners(const TriangleMesh& mesh, std::size_t triangle) {
    TriangleCorners corners = cornersOf(mesh, triangle);
    std::sort(corners.begin(), corners.end(), precedes);
    return corners;
}

/// An order of sorted corners, for sets and maps of them.
struct ByPositions {
    bool operator()(const TriangleCorners& a, const TriangleCorners& b) const {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), precedes);
    }
};

}  // namespace sherd
