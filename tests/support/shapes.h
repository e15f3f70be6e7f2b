#pragma once

#include <sherd/triangle_mesh.h>

#include <cmath>
#include <functional>
#include <map>
#include <vector>

/// Closed surfaces with known volumes, for tests. All are oriented outward and share vertices.
namespace sherd::shapes {

/// The filled cells of a rectilinear grid as one solid: filled(i, j, k) is asked for every cell between xs[i]
/// and xs[i + 1] and so on. Vertices are shared, so filled cells must not meet at an edge or a corner alone.
inline TriangleMesh rectilinear(const std::vector<double>& xs, const std::vector<double>& ys,
                                const std::vector<double>& zs,
                                const std::function<bool(int, int, int)>& filled) {
    const std::vector<double>* lines[3] = {&xs, &ys, &zs};
    const int count[3] = {int(xs.size()) - 1, int(ys.size()) - 1, int(zs.size()) - 1};
    const auto solid = [&](const std::array<int, 3>& c) {
        for (int d = 0; d < 3; ++d)
            if (c[d] < 0 || c[d] >= count[d]) return false;
        return filled(c[0], c[1], c[2]);
    };
    TriangleMesh mesh;
    std::map<std::array<int, 3>, int> vertex_of;
    const auto vertex = [&](const std::array<int, 3>& corner) {
        const auto [entry, added] = vertex_of.try_emplace(corner, int(mesh.vertices.size()));
        if (added)
            mesh.vertices.emplace_back((*lines[0])[corner[0]], (*lines[1])[corner[1]],
                                       (*lines[2])[corner[2]]);
        return entry->second;
    };
    const auto addFace = [&](std::array<int, 3> corner, int axis, bool upward) {
        int loop[4];
        const int e = (axis + 1) % 3, f = (axis + 2) % 3;
        for (int q = 0; q < 4; ++q) {
            std::array<int, 3> c = corner;
            c[e] += q == 1 || q == 2;
            c[f] += q >= 2;
            loop[upward ? q : 3 - q] = vertex(c);
        }
        mesh.triangles.push_back({loop[0], loop[1], loop[2]});
        mesh.triangles.push_back({loop[0], loop[2], loop[3]});
    };
    for (int k = 0; k < count[2]; ++k)
        for (int j = 0; j < count[1]; ++j)
            for (int i = 0; i < count[0]; ++i) {
                const std::array<int, 3> cell = {i, j, k};
                if (!solid(cell)) continue;
                for (int axis = 0; axis < 3; ++axis) {
                    std::array<int, 3> above = cell, below = cell;
                    ++above[axis];
                    --below[axis];
                    if (!solid(above)) addFace(above, axis, true);
                    if (!solid(below)) addFace(cell, axis, false);
                }
            }
    return mesh;
}

/// Evenly spaced values from a to b, both included.
inline std::vector<double> lines(double a, double b, int intervals) {
    std::vector<double> values(intervals + 1);
    for (int i = 0; i <= intervals; ++i) values[i] = i == intervals ? b : a + (b - a) * i / intervals;
    return values;
}

/// An axis-aligned box, each face split into squares.
inline TriangleMesh box(const Vec3& lower, const Vec3& upper, int nx = 1, int ny = 1, int nz = 1) {
    return rectilinear(lines(lower.x(), upper.x(), nx), lines(lower.y(), upper.y(), ny),
                       lines(lower.z(), upper.z(), nz), [](int, int, int) { return true; });
}

/// A box of the given size about the origin.
inline TriangleMesh slab(const Vec3& size, int nx = 1, int ny = 1, int nz = 1) {
    return box(-size / 2, size / 2, nx, ny, nz);
}

/// x -> rotation x + offset, applied to every vertex. The rotation must be proper.
inline TriangleMesh moved(TriangleMesh mesh, const Mat3& rotation, const Vec3& offset = Vec3::Zero()) {
    for (Vec3& v : mesh.vertices) v = (rotation * v + offset).eval();
    return mesh;
}

inline TriangleMesh translated(const TriangleMesh& mesh, const Vec3& offset) {
    return moved(mesh, Mat3::Identity(), offset);
}

/// A rotation about no axis of symmetry.
inline Mat3 tilt(double angle_rad = 0.7) {
    return Eigen::AngleAxisd(angle_rad, Vec3(1, 2, 3).normalized()).toRotationMatrix();
}

/// The same surface seen from the other side: as an inner shell it makes a cavity.
inline TriangleMesh inverted(TriangleMesh mesh) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

/// Both surfaces in one mesh.
inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
    const int first = int(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return a;
}

/// An icosahedron split `levels` times, its vertices on a sphere about the origin: 20 * 4^levels triangles.
inline TriangleMesh icosphere(double radius, int levels) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    TriangleMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middle_of;
        const auto middle = [&](int a, int b) {
            const auto [entry, added] = middle_of.try_emplace(std::minmax(a, b), int(mesh.vertices.size()));
            if (added) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
            return entry->second;
        };
        for (Vec3& v : mesh.vertices) v.normalize();
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.triangles = finer;
    }
    for (Vec3& v : mesh.vertices) v = (radius * v.normalized()).eval();
    return mesh;
}

inline TriangleMesh hollowSphere(double outer_radius, double inner_radius, int levels) {
    return joined(icosphere(outer_radius, levels), inverted(icosphere(inner_radius, levels)));
}

/// A surface of revolution about z: a closed profile of (radius > 0, z) points, counter-clockwise with the
/// radius to the right and z up, so that a ring-shaped solid comes out.
inline TriangleMesh revolved(const std::vector<std::pair<double, double>>& profile, int segments) {
    const double turn = 2 * std::acos(-1.0) / segments;
    const int n = int(profile.size());
    TriangleMesh mesh;
    for (int s = 0; s < segments; ++s)
        for (const auto& [r, z] : profile)
            mesh.vertices.emplace_back(r * std::cos(turn * s), r * std::sin(turn * s), z);
    for (int s = 0; s < segments; ++s)
        for (int q = 0; q < n; ++q) {
            const int a = s * n + q, b = s * n + (q + 1) % n;
            const int c = (s + 1) % segments * n + (q + 1) % n, d = (s + 1) % segments * n + q;
            mesh.triangles.push_back({a, d, c});
            mesh.triangles.push_back({a, c, b});
        }
    return mesh;
}

/// A tube about z from z = 0 to `length`.
inline TriangleMesh tube(double outer_radius, double inner_radius, double length, int segments) {
    return revolved({{inner_radius, 0}, {outer_radius, 0}, {outer_radius, length}, {inner_radius, length}},
                    segments);
}

/// The same for a profile whose first and last point are next to the axis: fans about points on the axis, as
/// high as these two, close it.
inline TriangleMesh revolvedSolid(const std::vector<std::pair<double, double>>& profile, int segments) {
    TriangleMesh mesh = revolved(profile, segments);
    // The ring's innermost strip, from the last point of the profile to the first, becomes two fans.
    const int n = int(profile.size()), bottom = int(mesh.vertices.size()), top = bottom + 1;
    mesh.vertices.emplace_back(0, 0, profile.front().second);
    mesh.vertices.emplace_back(0, 0, profile.back().second);
    std::vector<std::array<int, 3>> kept;
    for (int t = 0; t < int(mesh.triangles.size()); ++t)
        if (t / 2 % n != n - 1) kept.push_back(mesh.triangles[t]);
    for (int s = 0; s < segments; ++s) {
        const int next = (s + 1) % segments;
        kept.push_back({bottom, next * n, s * n});
        kept.push_back({top, s * n + n - 1, next * n + n - 1});
    }
    mesh.triangles = kept;
    return mesh;
}

/// An open cup about z, standing on z = 0: wall and floor of the same thickness. The floor is flat, its
/// middle a fan.
inline TriangleMesh cup(double outer_radius, double height, double wall, int segments, int rows) {
    std::vector<std::pair<double, double>>
        profile;  // from the axis out along the floor, up, over the rim and back
    const double inner = outer_radius - wall;
    for (int i = 1; i <= rows; ++i) profile.emplace_back(outer_radius * i / rows, 0);
    for (int i = 1; i <= rows; ++i) profile.emplace_back(outer_radius, height * i / rows);
    for (int i = 0; i < rows; ++i) profile.emplace_back(inner, height - (height - wall) * i / rows);
    for (int i = 0; i < rows; ++i) profile.emplace_back(inner * (rows - i) / rows, wall);
    return revolvedSolid(profile, segments);
}

/// The lower half of a hollow sphere about the origin.
inline TriangleMesh bowl(double outer_radius, double wall, int segments, int rows) {
    const double step = std::acos(0.0) / rows, inner = outer_radius - wall;
    std::vector<std::pair<double, double>> profile;
    for (int i = 1; i <= rows; ++i)
        profile.emplace_back(outer_radius * std::sin(step * i), -outer_radius * std::cos(step * i));
    for (int i = rows; i >= 1; --i)
        profile.emplace_back(inner * std::sin(step * i), -inner * std::cos(step * i));
    return revolvedSolid(profile, segments);
}

/// A square tray open at the top: a U in the x-z plane, drawn out along y. Legs of the given thickness on a
/// floor of the same, a gap between them.
inline TriangleMesh uShape(double leg, double gap, double height, double depth) {
    return rectilinear({0, leg, leg + gap, 2 * leg + gap}, {0, depth}, {0, leg, height},
                       [](int i, int, int k) { return k == 0 || i != 1; });
}

}  // namespace sherd::shapes
