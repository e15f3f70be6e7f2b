#pragma once

#include <vector>

#include "geometry/cutting/surface_crossing.h"

namespace sherd {

/// The surface of the body and crack faces, split where they cross, and told apart.
struct CutFaces {
    std::vector<Vec3> points;      ///< m
    std::vector<Triangle> body;    ///< in the order of their parents
    std::vector<int> body_parent;  ///< #body
    std::vector<int> body_label;   ///< #body
    std::vector<int> body_set;     ///< #body; equal for those that hang together and share a label
    std::vector<Triangle> crack;   ///< those inside the solid only
    std::vector<CrackComplex::Sides> crack_sides;  ///< #crack
};

/// What became of an attempt to cut.
struct CutAttempt {
    CutFaces faces;
    std::vector<int> troubled;  ///< crack triangles to be moved before another attempt; empty: see `failure`
    const char* failure =
        nullptr;  ///< why nothing came out although no single triangle is to blame, or nullptr
};

/// Splits the crossed triangles of both (constrained Delaunay), labels the body's triangles by the side of
/// the crack segments, and keeps the crack faces that are inside the solid.
CutAttempt cutFaces(const TriangleMesh& body, const EdgeTable& body_edges, const LabelLattice& lattice,
                    const CrackComplex& crack);

}  // namespace sherd
