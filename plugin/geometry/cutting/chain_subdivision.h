#pragma once

#include <utility>
#include <vector>

#include "geometry/cutting/plane_projection.h"
#include "geometry/cutting/triangle_subdivision.h"

namespace sherd {

/// Splits a triangle along segments that form chains from one point of its boundary to another, as nearly all
/// do: the chains leave polygons, and these are triangulated, Delaunay within each. The same triangles as a
/// constrained Delaunay triangulation of the whole, in a small part of its time.
class ChainSubdivision {
  public:
    /// As TriangleSubdivision::split. False too if a segment belongs to no such chain.
    bool split(const std::vector<Vec3>& points, const Vec3& normal, const std::vector<int>& loop,
               const std::vector<std::pair<int, int>>& segments, std::vector<Triangle>& out,
               TrianglePolygons& polygons);

  private:
    struct Point {
        int id;
        PlaneKernel::Point_2 place;
        int neighbours[2];  // along segments
        int ways[2];        // to these: twice the segment, and 1 where it runs the other way
        int degree;
    };

    bool connect(const std::vector<Vec3>& points, const Vec3& normal,
                 const std::vector<std::pair<int, int>>& segments);
    int localOf(int id, const std::vector<Vec3>& points, const Vec3& normal);
    bool addPolygon(int first_edge, int edge_count, TrianglePolygons& polygons);
    int followChain(int at, int edge_count, TrianglePolygons& polygons);
    bool triangulatePolygon();
    bool isEar(std::size_t corner) const;
    void flipToDelaunay(std::size_t first);
    bool flipAcross(std::size_t first, std::size_t triangle, int edge);
    bool isLeftTurn(int a, int b, int c) const;

    std::vector<Point> points_;  // those of the loop, then the inner ones
    std::vector<int> polygon_;
    std::vector<Triangle> triangles_;  // of points_
};

}  // namespace sherd
