#pragma once

#include <sherd/types.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sherd {

/// A small planar polygon without repeated corners. A triangle cut by the six planes of a cell has nine
/// corners at most; there is room for more since rounding may make a polygon slightly concave.
struct Polygon {
    std::array<Vec3, 24> points;
    int count = 0;

    void add(const Vec3& p) {
        if (count > 0 && points[count - 1] == p) return;
        if (count < int(points.size())) points[count++] = p;
    }
    void close() {
        while (count > 1 && points[count - 1] == points[0]) --count;
    }
    void assign(const Polygon& other) {  // copies only the corners in use
        count = other.count;
        for (int i = 0; i < count; ++i) points[i] = other.points[i];
    }
};

/// Cuts a polygon in two at x[axis] = plane. A corner on the plane belongs to `above`. A cut point depends
/// on the ends of its edge but not on their order, so triangles that share an edge get the same bits.
void cutPolygon(const Polygon& polygon, int axis, double plane, Polygon& below, Polygon& above);

/// Calls visit(cell, piece) for the part of the polygon inside each cell of the unit grid, in ascending order
/// along x, then y, then z. Pieces with fewer than three corners are left out.
template <class Visit>
void forEachCellPiece(const Polygon& polygon, Visit&& visit, int axis = 0,
                      Eigen::Vector3i cell = Eigen::Vector3i::Zero()) {
    if (polygon.count < 3) return;
    if (axis == 3) {
        visit(cell, polygon);
        return;
    }
    double lowest = polygon.points[0][axis], highest = lowest;
    for (int i = 1; i < polygon.count; ++i) {
        lowest = std::min(lowest, polygon.points[i][axis]);
        highest = std::max(highest, polygon.points[i][axis]);
    }
    const int first = int(std::floor(lowest)), last = int(std::floor(highest));
    cell[axis] = first;
    if (first == last) return forEachCellPiece(polygon, visit, axis + 1, cell);
    Polygon below, above, rest;
    rest.assign(polygon);
    for (int i = first; i < last; ++i) {
        cutPolygon(rest, axis, i + 1, below, above);
        cell[axis] = i;
        forEachCellPiece(below, visit, axis + 1, cell);
        rest.assign(above);
    }
    cell[axis] = last;
    forEachCellPiece(rest, visit, axis + 1, cell);
}

}  // namespace sherd
