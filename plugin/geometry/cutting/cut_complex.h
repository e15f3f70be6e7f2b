#pragma once

#include <sherd/triangle_mesh.h>

#include <cstdint>
#include <initializer_list>
#include <unordered_map>
#include <vector>

#include "geometry/cutting/edge_table.h"

namespace sherd {

/// The faces between the parts of a body: triangles that are split where cuts cross them, so that at any time
/// all that meet in an edge have it in common, or can be split until they do.
class CutComplex {
  public:
    static constexpr int outside = -1;  ///< the part beyond the body's surface

    /// A triangle between two parts. Its normal points from the one below to the one above.
    struct Face {
        Triangle corners;
        int parts[2] = {outside, outside};  ///< below and above
        int parent = -1;                    ///< triangle of the body; -1 on cracks
        int first_child = -1;               ///< of those that it was split into; -1: it is whole
        int child_count = 0;
    };
    /// A face as one of its parts sees it: 0 from below, 1 from above.
    struct FaceSide {
        int face, side;
    };

    /// At first the body's triangles, in their order.
    explicit CutComplex(const TriangleMesh& body);

    const std::vector<Vec3>& points() const { return points_; }
    const std::vector<Face>& faces() const { return faces_; }
    int pointCount() const { return static_cast<int>(points_.size()); }
    int bodyPointCount() const { return body_point_count_; }
    std::vector<Vec3> takePoints() { return std::move(points_); }

    /// Adds a face of a crack; returns its number.
    int addCrackFace(const Triangle& corners);
    /// Adds a point on the edge between two others; all faces along it are to be split there, by `split` or,
    /// where they bound other parts, by `refine`.
    int addPointOnEdge(int a, int b, const Vec3& x);
    void split(int face, std::initializer_list<Triangle> parts);
    /// Splits a whole face at a point on one of its edges, if there is one; its parts may be refined further.
    void refine(int face);
    /// Says which part is on a side of a face that is whole.
    void setPart(const FaceSide& at, int part) { faces_[at.face].parts[at.side] = part; }

    /// Refines the faces and appends what whole ones have become of them.
    void appendWhole(const FaceSide& at, std::vector<FaceSide>& whole);
    void refineAll();

  private:
    std::vector<Vec3> points_;
    int body_point_count_, body_face_count_;
    std::vector<char> has_split_edge_;  // #points, whether one ends there that is in `on_edges_`
    std::vector<Face> faces_;
    std::unordered_map<std::uint64_t, int> on_edges_;  // of cracks, which faces of several parts share
    std::vector<int> front_;
};

}  // namespace sherd
