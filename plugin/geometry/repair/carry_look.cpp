#include "geometry/repair/carry_look.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/numerics/union_find.h"
#include "geometry/by_position.h"
#include "geometry/mesh_attributes.h"
#include "geometry/triangle_tree.h"

namespace sherd {
namespace {

using Triangle = std::array<int, 3>;

Vec3 normalOf(const TriangleCorners& corners) {
    return areaVector(corners).stableNormalized();
}

/// Weights of the corners that give x, which lies in the triangle's plane or near it; those of the first
/// corner for a triangle without area.
Vec3 weights(const TriangleCorners& corners, const Vec3& x) {
    const Vec3 &a = corners[0], &b = corners[1], &c = corners[2];
    const Vec3 normal = (b - a).cross(c - a);
    const double squared = normal.squaredNorm();
    if (!(squared > 0)) return Vec3::UnitX();
    return Vec3(normal.dot((b - x).cross(c - x)), normal.dot((c - x).cross(a - x)),
                normal.dot((a - x).cross(b - x))) /
           squared;
}

template <class Vector>
Vector mixed(const std::array<Vector, 3>& values, const Vec3& w) {
    return w[0] * values[0] + w[1] * values[1] + w[2] * values[2];
}

/// Parts of the texture map: triangles that meet in an edge with the same texture coordinates.
std::vector<int> chartsOf(const TriangleMesh& mesh) {
    UnionFind charts(static_cast<int>(mesh.triangles.size()));
    using End = std::array<double, 5>;
    std::map<std::pair<End, End>, int> first_at;
    const auto end = [&](std::size_t t, int k) {
        const Vec3& x = mesh.vertices[mesh.triangles[t][k]];
        const Vec2& uv = mesh.texture_coordinates[t][k];
        return End{x.x(), x.y(), x.z(), uv.x(), uv.y()};
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const End a = end(t, k), b = end(t, (k + 1) % 3);
            const auto [entry, is_new] = first_at.try_emplace(std::minmax(a, b), static_cast<int>(t));
            if (!is_new) charts.unite(entry->second, static_cast<int>(t));
        }
    std::vector<int> chart_of(mesh.triangles.size());
    for (std::size_t t = 0; t < chart_of.size(); ++t) chart_of[t] = charts.root(static_cast<int>(t));
    return chart_of;
}

class Look {
  public:
    explicit Look(const TriangleMesh& original) : from_(original), tree_(original) {
        if (!from_.texture_coordinates.empty()) charts_ = chartsOf(from_);
        for (std::size_t t = 0; t < from_.triangles.size(); ++t)
            same_.try_emplace(sortedCorners(from_, t), static_cast<int>(t));
    }

    void carry(TriangleMesh& mesh) const {
        mesh.materials = from_.materials;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const TriangleCorners corners = cornersOf(mesh, t);
            const auto same = same_.find(sortedCorners(mesh, t));
            if (same != same_.end())
                addSame(mesh, corners, same->second);
            else
                addNearest(mesh, corners);
        }
        if (!from_.colours.empty())
            for (const Vec3& vertex : mesh.vertices) mesh.colours.push_back(colourAt(vertex));
    }

  private:
    using Foot = TriangleTree::Foot;

    Vec3 weightsOf(int triangle, const Vec3& x) const { return weights(cornersOf(from_, triangle), x); }

    /// In the order of the new triangle's corners, which may start elsewhere or be turned.
    void addSame(TriangleMesh& mesh, const TriangleCorners& corners, int t) const {
        const auto old = cornersOf(from_, t);
        std::array<int, 3> of{};
        for (int i = 0; i < 3; ++i)
            of[i] = static_cast<int>(std::find(old.begin(), old.end(), corners[i]) - old.begin());
        if (!from_.texture_coordinates.empty()) {
            const auto& uv = from_.texture_coordinates[t];
            mesh.texture_coordinates.push_back({uv[of[0]], uv[of[1]], uv[of[2]]});
        }
        if (!from_.normals.empty()) {
            const double side = normalOf(old).dot(normalOf(corners)) < 0 ? -1 : 1;
            const auto& n = from_.normals[t];
            mesh.normals.push_back({side * n[of[0]], side * n[of[1]], side * n[of[2]]});
        }
        if (!from_.material.empty()) mesh.material.push_back(from_.material[t]);
    }

    void addNearest(TriangleMesh& mesh, const TriangleCorners& corners) const {
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        const Foot centre = tree_.nearest(middle);
        constexpr double inward =
            0.05;  // of the way to the middle, so that a corner on a seam takes its own side
        std::array<Foot, 3> feet{centre, centre, centre};
        for (int i = 0; i < 3; ++i) feet[i] = tree_.nearest(corners[i] + inward * (middle - corners[i]));
        if (!from_.texture_coordinates.empty()) {
            auto& uv = mesh.texture_coordinates.emplace_back();
            for (int i = 0; i < 3; ++i) uv[i] = textureAt(feet[i], centre, corners[i]);
        }
        if (!from_.normals.empty()) {
            auto& n = mesh.normals.emplace_back();
            for (int i = 0; i < 3; ++i) n[i] = normalAt(feet[i], normalOf(corners));
        }
        if (!from_.material.empty()) mesh.material.push_back(from_.material[centre.triangle]);
    }

    Vec2 textureAt(const Foot& foot, const Foot& centre, const Vec3& corner) const {
        const bool same_chart = charts_[foot.triangle] == charts_[centre.triangle];
        const int t = same_chart ? foot.triangle : centre.triangle;
        return mixed(from_.texture_coordinates[t], weightsOf(t, same_chart ? foot.position : corner));
    }

    /// The mesh's normal there, on the side that the new triangle faces; the triangle's own where the mesh
    /// gives none or looks elsewhere.
    Vec3 normalAt(const Foot& foot, const Vec3& own) const {
        Vec3 normal =
            mixed(from_.normals[foot.triangle], weightsOf(foot.triangle, foot.position)).stableNormalized();
        if (normal.dot(own) < 0) normal = -normal;
        constexpr double elsewhere = 0.5;  // cosine, 60 degrees
        return normal.dot(own) < elsewhere ? own : normal;
    }

    Vec3 colourAt(const Vec3& x) const {
        const Foot foot = tree_.nearest(x);
        const Triangle& t = from_.triangles[foot.triangle];
        for (const int corner : t)
            if (from_.vertices[corner] == x) return from_.colours[corner];
        const Vec3 w = weightsOf(foot.triangle, foot.position).cwiseMax(0).cwiseMin(1);
        return mixed(std::array<Vec3, 3>{from_.colours[t[0]], from_.colours[t[1]], from_.colours[t[2]]},
                     Vec3(w / w.sum()));
    }

    const TriangleMesh& from_;
    TriangleTree tree_;
    std::vector<int> charts_;
    std::map<TriangleCorners, int, ByPositions> same_;
};

}  // namespace

void carryLook(const TriangleMesh& original, TriangleMesh& mesh) {
    if (hasAttributes(original)) Look(original).carry(mesh);
}

}  // namespace sherd
