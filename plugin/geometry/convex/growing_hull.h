#pragma once

#include <sherd/types.h>

#include <array>
#include <vector>

namespace sherd {

/// A convex hull that grows by the point that is furthest outside it (quickhull, Barber et al. 1996): its
/// first few vertices come nearest to the hull of all points. Each face keeps points outside it, and only
/// those are looked at again when it is replaced.
class GrowingHull {
  public:
    /// The hull of the points that are outermost in 26 directions.
    explicit GrowingHull(const std::vector<Vec3>& points);

    /// Whether the points lie in a plane or on a line, or nearly so (to 2e-4 of their extent): no hull then.
    bool isFlat() const { return faces_.empty(); }
    /// Adds points until there are `most_vertices` or none lies further outside than `tolerance_m`.
    void growTo(int most_vertices, double tolerance_m);

    /// Which of the points are vertices, ascending.
    std::vector<int> vertices() const;
    double volume() const;   ///< m^3
    double outside() const;  ///< how far a point lies outside; 0 up to the tolerance, m

  private:
    struct Face {
        std::array<int, 3> corners{}, neighbours{};        // neighbour i is beyond corners i and i + 1
        Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // outward, unit; zero of a face without an area
        float height = 0;
        int first = -1, furthest = -1;  // of the points outside
        float distance = 0;             // of the furthest one
        bool is_there = true;
    };
    /// A side of the hole that is left when faces are taken away, and the face beyond it.
    struct Side {
        int from = 0, to = 0, beyond = 0, place = 0;  // among the neighbours of the face beyond
    };
    /// Points that are to be shared out among faces, side by side.
    struct Points {
        std::vector<float> x, y, z, distance;
        std::vector<int> which, face;
    };

    Vec3 at(int point) const { return {x_[point], y_[point], z_[point]}; }
    std::vector<int> outermostIn(const Vec3& box_sizes) const;
    std::vector<int> firstCorners(const std::vector<int>& points) const;
    void makeFirstFaces(const std::vector<int>& corners);
    int makeFace(int a, int b, int c);
    bool isSeen(int face, int point, bool slivers) const;
    void findSeen(int point, int face, bool slivers);
    bool findSides();
    void replaceSeen(int point);
    bool add(int point, int face);
    void takeUp(int point);
    void shareOut();
    int highestFace() const;
    void addUpTo(int most_vertices);

    float rounding_ = 0, tolerance_ = 0, left_out_ = 0;  // m; of points that could not be added
    std::vector<float> x_, y_, z_;                       // about the middle of the box
    std::vector<Face> faces_;
    std::vector<int> next_;  // of the points outside the same face
    int vertex_count_ = 0;
    // Kept for the memory alone, from one point to the next.
    std::vector<int> free_, seen_, new_faces_, side_at_;
    std::vector<char> is_seen_;
    std::vector<Side> sides_, ordered_;
    Points points_;
};

}  // namespace sherd
