#pragma once

#include <sherd/triangle_mesh.h>

#include <memory>
#include <optional>
#include <vector>

namespace sherd {

/// CGAL's search tree over the triangles of a mesh, which have the mesh's numbers. Built again for each mesh:
/// it does not follow changes. Once `prepareNearest` was called, several threads may ask at once.
class TriangleTree {
  public:
    explicit TriangleTree(const TriangleMesh& mesh);
    ~TriangleTree();
    TriangleTree(const TriangleTree&) = delete;
    TriangleTree& operator=(const TriangleTree&) = delete;

    /// A point of the surface.
    struct Foot {
        Vec3 position = Vec3::Zero();
        int triangle = -1;
    };
    /// What a ray meets.
    struct Hit {
        std::optional<Vec3> place;  ///< none if the ray runs along the triangle
        int triangle = -1;
    };

    void prepareNearest();
    /// The point of the surface that is nearest to x.
    Foot nearest(const Vec3& x) const;
    /// From x to one of the triangles.
    double distance(const Vec3& x, int triangle) const;
    /// The first triangle, but for `left_out`, that the ray from a point through another one meets.
    std::optional<Hit> firstHit(const Vec3& from, const Vec3& through, int left_out = -1) const;
    /// The triangles that are no further from x than `distance`, ascending.
    std::vector<int> within(double distance, const Vec3& x) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sherd
