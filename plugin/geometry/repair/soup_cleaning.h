#pragma once

#include <sherd/repair.h>

namespace sherd {

/// Stitches: vertices at one position become one, and so do those on borders, or `all`, within `tolerance`
/// (m). Returns the mesh without attributes; counts what it merged.
TriangleMesh stitched(const TriangleMesh& mesh, double tolerance, bool all, RepairReport& report);

/// Takes out triangles that are there twice. Two with the same corners that face each other are a wall inside
/// if a surface that is drawn from one side goes on at all of its rim, and both go; of a sheet that is drawn
/// from both sides one stays.
void dropDoubled(TriangleMesh& mesh, RepairReport& report);

/// Turns triangles until neighbours agree (CGAL's orientation of polygon soups); does nothing if they do.
void orientAlike(TriangleMesh& mesh, RepairReport& report);

}  // namespace sherd
