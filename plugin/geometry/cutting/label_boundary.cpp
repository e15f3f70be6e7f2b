#include "geometry/cutting/label_boundary.h"

namespace sherd {

LabelBoundary labelBoundary(const CutFaces& faces) {
    LabelBoundary boundary;
    boundary.triangles.reserve(faces.body.size() + 2 * faces.crack.size());
    boundary.labels.reserve(faces.body.size() + 2 * faces.crack.size());
    boundary.triangles = faces.body;
    boundary.labels = faces.body_label;
    boundary.body_count = static_cast<int>(faces.body.size());
    for (std::size_t c = 0; c < faces.crack.size(); ++c) {
        const auto& [p, q, r] = faces.crack[c];
        // The normal points out of the label below and into the label above.
        boundary.triangles.push_back({p, q, r});
        boundary.triangles.push_back({p, r, q});
        boundary.labels.push_back(faces.crack_sides[c].below);
        boundary.labels.push_back(faces.crack_sides[c].above);
    }
    return boundary;
}

}  // namespace sherd
