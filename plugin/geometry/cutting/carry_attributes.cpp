#include "geometry/cutting/carry_attributes.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/numerics/mesh_measures.h"
#include "geometry/cutting/edge_table.h"
#include "geometry/cutting/spread_colours.h"
#include "geometry/mesh_attributes.h"

namespace sherd {

namespace {

constexpr double smallest_cosine = 0.3;  // between a crack triangle and the axis along which it is projected

int longestAxis(const Vec3& v) {
    int axis = 0;
    v.cwiseAbs().maxCoeff(&axis);
    return axis;
}

// For every neighbour of a piece the axis along which most of the crack between them is seen; the same from
// both sides.
std::map<int, int> projectionAxes(const FragmentSurface& piece) {
    std::map<int, Vec3> seen;
    for (std::size_t t = 0; t < piece.parents.size(); ++t)
        if (piece.parents[t] < 0)
            seen.try_emplace(piece.across[t], Vec3::Zero()).first->second +=
                areaVector(cornersOf(piece.mesh, t)).cwiseAbs();
    std::map<int, int> axes;
    for (const auto& [neighbour, area] : seen) axes[neighbour] = longestAxis(area);
    return axes;
}

std::array<Vec2, 3> projected(const TriangleMesh& mesh, const Triangle& t, const Vec3& normal, int axis) {
    if (std::abs(normal[axis]) < smallest_cosine) axis = longestAxis(normal);
    std::array<Vec2, 3> result;
    for (int i = 0; i < 3; ++i) {
        const Vec3& x = mesh.vertices[t[i]];
        result[i] = Vec2(x[(axis + 1) % 3], x[(axis + 2) % 3]);
    }
    return result;
}

class AttributeCarrier {
  public:
    explicit AttributeCarrier(const TriangleMesh& body) : body_(body) {
        if (body_.material.empty() && !body_.texture_coordinates.empty())
            body_.material.assign(body_.triangles.size(), findOrAddMaterial(body_, "original"));
        if (!body_.material.empty()) crack_material_ = findOrAddMaterial(body_, "crack");
    }

    void carryCorners(FragmentSurface& piece) const {
        const std::map<int, int> axes = projectionAxes(piece);
        piece.mesh.materials = body_.materials;
        for (int t = 0; t < static_cast<int>(piece.parents.size()); ++t) {
            if (piece.parents[t] < 0)
                addCrackTriangle(piece, t, axes.at(piece.across[t]));
            else
                addBodyTriangle(piece, t);
        }
    }

    std::vector<Vec3> colours(const std::vector<FragmentSurface>& pieces,
                              const SharedVertices& shared) const {
        std::vector<Vec3> colours(shared.count, unknown_colour);
        for (std::size_t p = 0; p < pieces.size(); ++p)
            for (std::size_t t = 0; t < pieces[p].parents.size(); ++t) {
                if (pieces[p].parents[t] < 0) continue;
                const Triangle& parent = body_.triangles[pieces[p].parents[t]];
                for (int v : pieces[p].mesh.triangles[t]) {
                    Vec3& colour = colours[shared.of_piece[p][v]];
                    if (colour == unknown_colour)
                        colour = at(pieces[p].mesh.vertices[v], parent,
                                    std::array<Vec3, 3>{body_.colours[parent[0]], body_.colours[parent[1]],
                                                        body_.colours[parent[2]]});
                }
            }
        return colours;
    }

  private:
    // Barycentric coordinates of x projected to the plane of a triangle, negative ones set to zero.
    Vec3 barycentric(const Triangle& t, const Vec3& x) const {
        const Vec3 &a = body_.vertices[t[0]], &b = body_.vertices[t[1]], &c = body_.vertices[t[2]];
        const Vec3 normal = (b - a).cross(c - a);
        Vec3 w(normal.dot((b - x).cross(c - x)), normal.dot((c - x).cross(a - x)),
               normal.dot((a - x).cross(b - x)));
        w = w.cwiseMax(0);
        return w / w.sum();
    }

    template <class Vector>
    Vector at(const Vec3& x, const Triangle& t, const std::array<Vector, 3>& values) const {
        for (int i = 0; i < 3; ++i)
            if (x == body_.vertices[t[i]]) return values[i];
        const Vec3 w = barycentric(t, x);
        return w[0] * values[0] + w[1] * values[1] + w[2] * values[2];
    }

    template <class Vector>
    std::array<Vector, 3> atCorners(const FragmentSurface& piece, int t,
                                    const std::vector<std::array<Vector, 3>>& attribute) const {
        const int parent = piece.parents[t];
        std::array<Vector, 3> result;
        for (int i = 0; i < 3; ++i)
            result[i] = at(piece.mesh.vertices[piece.mesh.triangles[t][i]], body_.triangles[parent],
                           attribute[parent]);
        return result;
    }

    void addBodyTriangle(FragmentSurface& piece, int t) const {
        TriangleMesh& mesh = piece.mesh;
        const int parent = piece.parents[t];
        if (!body_.texture_coordinates.empty())
            mesh.texture_coordinates.push_back(atCorners(piece, t, body_.texture_coordinates));
        if (!body_.normals.empty()) {
            mesh.normals.push_back(atCorners(piece, t, body_.normals));
            for (Vec3& n : mesh.normals.back()) {
                const auto& given = body_.normals[parent];
                if (std::find(given.begin(), given.end(), n) == given.end()) n.normalize();
            }
        }
        if (!body_.material.empty()) mesh.material.push_back(body_.material[parent]);
    }

    void addCrackTriangle(FragmentSurface& piece, int t, int axis) const {
        TriangleMesh& mesh = piece.mesh;
        const Vec3 normal = areaVector(cornersOf(mesh, t)).normalized();
        if (!body_.texture_coordinates.empty())
            mesh.texture_coordinates.push_back(projected(mesh, mesh.triangles[t], normal, axis));
        if (!body_.normals.empty()) mesh.normals.push_back({normal, normal, normal});
        if (!body_.material.empty()) mesh.material.push_back(crack_material_);
    }

    TriangleMesh body_;
    int crack_material_ = -1;
};

Vec3 meanOf(const std::vector<Vec3>& colours) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& c : colours) sum += c;
    return sum / static_cast<double>(colours.size());
}

}  // namespace

void carryAttributes(const TriangleMesh& body, std::vector<FragmentSurface>& pieces) {
    if (!hasAttributes(body)) return;
    const AttributeCarrier carrier(body);
    for (FragmentSurface& piece : pieces) carrier.carryCorners(piece);
    if (body.colours.empty()) return;
    const SharedVertices shared = shareVertices(pieces);
    std::vector<Vec3> colours = carrier.colours(pieces, shared);
    spreadColours(pieces, shared, meanOf(body.colours), colours);
    for (std::size_t p = 0; p < pieces.size(); ++p)
        for (int v : shared.of_piece[p]) pieces[p].mesh.colours.push_back(colours[v]);
}

}  // namespace sherd
