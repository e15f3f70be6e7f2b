#include "geometry/cutting/cut_complex.h"

#include <algorithm>

namespace sherd {

namespace {

/// The number of an edge, whichever way it runs.
std::uint64_t edgeKey(int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

}  // namespace

CutComplex::CutComplex(const TriangleMesh& body)
    : points_(body.vertices),
      body_point_count_(static_cast<int>(body.vertices.size())),
      body_face_count_(static_cast<int>(body.triangles.size())),
      has_split_edge_(points_.size(), 0) {
    faces_.reserve(2 * body.triangles.size());
    for (const Triangle& corners : body.triangles) {
        Face face;
        face.corners = corners;
        face.parent = static_cast<int>(faces_.size());
        faces_.push_back(face);
    }
}

int CutComplex::addCrackFace(const Triangle& corners) {
    Face face;
    face.corners = corners;
    faces_.push_back(face);
    return static_cast<int>(faces_.size()) - 1;
}

int CutComplex::addPointOnEdge(int a, int b, const Vec3& x) {
    const int point = pointCount();
    points_.push_back(x);
    // Other edges are inside of one part, which splits all their faces itself.
    has_split_edge_.push_back(0);
    if (std::min(a, b) >= body_point_count_) {
        on_edges_.emplace(edgeKey(a, b), point);
        has_split_edge_[a] = has_split_edge_[b] = 1;
    }
    return point;
}

void CutComplex::split(int face, std::initializer_list<Triangle> parts) {
    const int first = static_cast<int>(faces_.size());
    Face part = faces_[face];
    faces_[face].first_child = first;
    faces_[face].child_count = static_cast<int>(parts.size());
    for (const Triangle& corners : parts) {
        part.corners = corners;
        faces_.push_back(part);
    }
}

void CutComplex::refine(int face) {
    if (faces_[face].first_child >= 0) return;
    const Triangle corners = faces_[face].corners;
    for (int i = 0; i < 3; ++i) {
        const int a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
        if (!has_split_edge_[a] || !has_split_edge_[b]) continue;
        const auto split_at = on_edges_.find(edgeKey(a, b));
        if (split_at == on_edges_.end()) continue;
        split(face, {{a, split_at->second, c}, {split_at->second, b, c}});
        return;
    }
}

void CutComplex::appendWhole(const FaceSide& at, std::vector<FaceSide>& whole) {
    if (at.face >= body_face_count_) refine(at.face);  // no edge of the body is shared by several parts
    if (faces_[at.face].first_child < 0) return whole.push_back(at);
    front_.assign(1, at.face);
    while (!front_.empty()) {
        const int face = front_.back();
        front_.pop_back();
        refine(face);
        if (faces_[face].first_child < 0) whole.push_back({face, at.side});
        for (int k = 0; k < faces_[face].child_count; ++k) front_.push_back(faces_[face].first_child + k);
    }
}

void CutComplex::refineAll() {
    for (auto f = static_cast<std::size_t>(body_face_count_); f < faces_.size(); ++f)
        refine(static_cast<int>(f));
}

}  // namespace sherd
