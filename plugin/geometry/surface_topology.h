#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <string>
#include <vector>

namespace sherd {

/// An edge of a closed surface: from vertices[0] to vertices[1] in triangles[0], the other way in
/// triangles[1].
struct SharedEdge {
    int vertices[2];
    int triangles[2];
};

/// What a surface is made of, and what keeps it from being a closed and oriented 2-manifold.
struct SurfaceTopology {
    std::vector<SharedEdge> edges;    ///< those of two triangles that run along them in opposite directions
    std::vector<std::string> faults;  ///< a sentence for each kind of fault, with its count and first places
    bool manifold = true;  ///< apart from its borders: no crowded edge, no pinch, no turned triangle
};
SurfaceTopology surfaceTopology(const TriangleMesh& mesh);

/// The edges of a surface, if it is a closed and oriented 2-manifold; each has two triangles that run along
/// it in opposite directions, and the triangles around each vertex form one fan. Indices must be in range.
Result<std::vector<SharedEdge>> closedManifoldEdges(const TriangleMesh& mesh);

/// The connected parts of a surface: a number for each triangle, from 0 in order of first appearance.
std::vector<int> shellOfTriangle(const TriangleMesh& mesh, const std::vector<SharedEdge>& edges);

/// "triangle 7", or "face 8" if the mesh knows the faces of its file.
std::string describeTriangle(const TriangleMesh& mesh, int triangle);
/// "triangles 3, 7 and 9": the first of a list.
std::string describeTriangles(const TriangleMesh& mesh, const std::vector<int>& triangles);

/// "(x, y, z)" with four digits, for sentences.
std::string describePlace(const Vec3& position);

}  // namespace sherd
