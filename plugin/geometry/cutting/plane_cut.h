#pragma once

#include <utility>
#include <vector>

#include "core/clustering/crack_tree.h"
#include "geometry/cutting/cut_complex.h"
#include "geometry/cutting/cuttable_surface.h"

namespace sherd {

/// What bounds a part of the body: blocks of triangles that no cut has crossed, and other faces.
struct PartBoundary {
    std::vector<int> blocks;
    std::vector<CutComplex::FaceSide> faces;
};

/// What a plane makes of a part's boundary.
struct PlaneCut {
    PartBoundary sides[2];  ///< at negative and at positive distances
    /// Directed edges along the cut; of the crack face that closes the lower side with its normal along the
    /// plane's.
    std::vector<std::pair<int, int>> outlines;
};

/// Cuts boundaries of parts by planes. Which faces are split, and into what, follows from the side of their
/// corners alone. A plane is moved by a twentieth of the particle spacing at most, so that no corner is very
/// near to it.
class PlaneCutter {
  public:
    PlaneCutter(const CuttableSurface& surface, double particle_spacing_m, CutComplex& complex);

    PlaneCut cut(const PartBoundary& boundary, const CrackPlane& plane);

  private:
    using FaceSide = CutComplex::FaceSide;

    struct CutEdge {
        int other, point;
        int next;  // of the same lower vertex, or -1
    };

    void takeBlocks(const std::vector<int>& blocks, const CrackPlane& plane, PlaneCut& cut);
    void measure(const CrackPlane& plane);
    double clearPlace();
    void splitFace(const FaceSide& at, PlaneCut& cut);
    int cutEdge(int a, int b);

    const CuttableSurface& surface_;
    double reach_m_;  // of the plane
    CutComplex& complex_;

    // Of one cut.
    int number_ = -1;
    std::vector<FaceSide> whole_;   // faces that the plane may cross
    std::vector<double> distance_;  // #points, of corners of these
    std::vector<int> seen_in_;      // #points, number of the cut
    std::vector<int> first_cut_;    // #points, of the edges with that lower vertex, or -1
    std::vector<CutEdge> cut_edges_;
    std::vector<int> corners_;
    std::vector<double> near_;
};

}  // namespace sherd
