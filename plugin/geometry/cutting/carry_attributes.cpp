#include "geometry/cutting/carry_attributes.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/parallel_chunks.h"
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

// Where on a triangle of the body a point is.
struct PlaceOnTriangle {
    int corner;    // -1: at none
    Vec3 weights;  // of the corners, if it is at none

    template <class Vector>
    Vector of(const std::array<Vector, 3>& values) const {
        if (corner >= 0) return values[corner];
        return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
    }
};

class AttributeCarrier {
  public:
    explicit AttributeCarrier(const TriangleMesh& body)
        : body_(body), has_material_(!body.material.empty() || !body.texture_coordinates.empty()) {
        TriangleMesh named;
        named.materials = body.materials;
        if (has_material_ && body.material.empty()) original_material_ = findOrAddMaterial(named, "original");
        if (has_material_) crack_material_ = findOrAddMaterial(named, "crack");
        materials_ = named.materials;
    }

    void carryCorners(FragmentSurface& piece) const {
        const std::map<int, int> axes = projectionAxes(piece);
        TriangleMesh& mesh = piece.mesh;
        mesh.materials = materials_;
        if (!body_.texture_coordinates.empty()) mesh.texture_coordinates.reserve(mesh.triangles.size());
        if (!body_.normals.empty()) mesh.normals.reserve(mesh.triangles.size());
        if (has_material_) mesh.material.reserve(mesh.triangles.size());
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
                        colour =
                            placeOn(parent, pieces[p].mesh.vertices[v])
                                .of(std::array<Vec3, 3>{body_.colours[parent[0]], body_.colours[parent[1]],
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

    PlaceOnTriangle placeOn(const Triangle& t, const Vec3& x) const {
        for (int i = 0; i < 3; ++i)
            if (x == body_.vertices[t[i]]) return {i, Vec3::Zero()};
        return {-1, barycentric(t, x)};
    }

    void addBodyTriangle(FragmentSurface& piece, int t) const {
        TriangleMesh& mesh = piece.mesh;
        const int parent = piece.parents[t];
        std::array<PlaceOnTriangle, 3> places;
        for (int i = 0; i < 3; ++i)
            places[i] = placeOn(body_.triangles[parent], mesh.vertices[mesh.triangles[t][i]]);
        if (!body_.texture_coordinates.empty()) {
            const auto& given = body_.texture_coordinates[parent];
            mesh.texture_coordinates.push_back(
                {places[0].of(given), places[1].of(given), places[2].of(given)});
        }
        if (!body_.normals.empty()) {
            const auto& given = body_.normals[parent];
            mesh.normals.push_back({places[0].of(given), places[1].of(given), places[2].of(given)});
            for (Vec3& n : mesh.normals.back())
                if (std::find(given.begin(), given.end(), n) == given.end()) n.normalize();
        }
        if (has_material_)
            mesh.material.push_back(body_.material.empty() ? original_material_ : body_.material[parent]);
    }

    void addCrackTriangle(FragmentSurface& piece, int t, int axis) const {
        TriangleMesh& mesh = piece.mesh;
        const Vec3 normal = areaVector(cornersOf(mesh, t)).normalized();
        if (!body_.texture_coordinates.empty())
            mesh.texture_coordinates.push_back(projected(mesh, mesh.triangles[t], normal, axis));
        if (!body_.normals.empty()) mesh.normals.push_back({normal, normal, normal});
        if (has_material_) mesh.material.push_back(crack_material_);
    }

    const TriangleMesh& body_;
    bool has_material_;
    std::vector<std::string> materials_;  // names
    int original_material_ = -1, crack_material_ = -1;
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
    forEachChunk(static_cast<int>(pieces.size()), [&](int p) { carrier.carryCorners(pieces[p]); });
    if (body.colours.empty()) return;
    const SharedVertices shared = shareVertices(pieces);
    std::vector<Vec3> colours = carrier.colours(pieces, shared);
    spreadColours(pieces, shared, meanOf(body.colours), colours);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        pieces[p].mesh.colours.reserve(shared.of_piece[p].size());
        for (int v : shared.of_piece[p]) pieces[p].mesh.colours.push_back(colours[v]);
    }
}

}  // namespace sherd
