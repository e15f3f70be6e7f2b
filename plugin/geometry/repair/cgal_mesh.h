#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

using RepairKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using RepairMesh = CGAL::Surface_mesh<RepairKernel::Point_3>;

/// Vertices and triangles as a half-edge mesh, in the same order. Triangles that no manifold can have are
/// left out; there are none after `partTouching`.
RepairMesh toRepairMesh(const TriangleMesh& mesh);

/// The vertices and triangles that are left, in order.
TriangleMesh toTriangleMesh(const RepairMesh& mesh);

/// The mesh of some of the triangles of another one, without attributes; vertices that none uses go.
TriangleMesh partOf(const TriangleMesh& mesh, const std::vector<int>& triangles);

/// Appends vertices and triangles.
void append(const TriangleMesh& part, TriangleMesh& mesh);

}  // namespace sherd
