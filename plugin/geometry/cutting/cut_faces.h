#pragma once

#include <vector>

#include "geometry/cutting/cuttable_surface.h"
#include "geometry/cutting/surface_crossing.h"

namespace sherd {

/// The surface of the body, labelled, and the crack faces inside it, both split where they cross.
struct CutFaces {
    std::vector<Vec3> points;      ///< the body's vertices, then points on cracks, m
    int body_point_count = 0;      ///< how many are the body's vertices
    std::vector<Triangle> body;    ///< in the order of their parents
    std::vector<int> body_parent;  ///< #body
    std::vector<int> body_label;   ///< #body
    std::vector<int> body_set;     ///< #body; equal for triangles that are connected within one label
    int body_set_count = 0;        ///< numbers of sets are below
    std::vector<Triangle> crack;   ///< inside the solid
    std::vector<CrackComplex::Sides> crack_sides;  ///< #crack
    std::vector<Vec3> smooth_normals;  ///< #crack, from below to above; empty: they are those of the faces
};

/// What became of an attempt to cut.
struct CutAttempt {
    CutFaces faces;
    std::vector<int> troubled;      ///< crack triangles to be moved before another attempt
    const char* failure = nullptr;  ///< why there are no faces although no single triangle is to blame
};

/// Splits the crossed triangles of both surfaces, labels the body's triangles by the side of the crack that
/// they lie on, and keeps the crack faces inside the solid.
CutAttempt cutFaces(const CuttableSurface& surface, const LabelLattice& lattice, const CrackComplex& crack);

}  // namespace sherd
