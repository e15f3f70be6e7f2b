#pragma once

#include <vector>

#include "geometry/cutting/cut_faces.h"

namespace sherd {

/// The triangles that bound the labels' regions: those of the body, then both sides of every crack face.
struct LabelBoundary {
    std::vector<Triangle> triangles;
    std::vector<int> labels;  ///< #triangles, of the region that each bounds
    int body_count = 0;       ///< how many are the body's

    /// The other side of a crack face; -1 for a triangle of the body.
    int opposite(int t) const { return t < body_count ? -1 : body_count + ((t - body_count) ^ 1); }
};

LabelBoundary labelBoundary(const CutFaces& faces);

}  // namespace sherd
