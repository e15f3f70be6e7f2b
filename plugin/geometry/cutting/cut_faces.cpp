#include "geometry/cutting/cut_faces.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/numerics/parallel_chunks.h"
#include "geometry/cutting/point_location.h"
#include "geometry/cutting/side_spreading.h"
#include "geometry/cutting/split_surface.h"

namespace sherd {

namespace {

// The label at a point of the solid that is not on a crack: that on the near side of the first crack on the
// way to the nearest lattice node, or that of the node if no crack is in the way. -1 if the way is
// degenerate.
int labelAt(const Vec3& x, const LabelLattice& lattice, const CrackComplex& crack) {
    const Eigen::Vector3i node = ((x - lattice.origin) / lattice.spacing).array().round().cast<int>();
    const int index = lattice.index(node.x(), node.y(), node.z());
    const FirstHit hit = firstHit(x, lattice.nodes[index], crack.points, crack.triangles);
    if (hit.degenerate) return -1;
    if (hit.triangle < 0) return lattice.labels[index];
    return hit.above ? crack.sides[hit.triangle].above : crack.sides[hit.triangle].below;
}

// Labels the shells of the body that no crack crosses. False if one could not be labelled.
bool labelUntouchedShells(const TriangleMesh& body, const LabelLattice& lattice, const CrackComplex& crack,
                          CutFaces& faces) {
    if (std::find(faces.body_label.begin(), faces.body_label.end(), -1) == faces.body_label.end())
        return true;
    std::vector<int> of_set(faces.body_set_count, -1);
    for (std::size_t t = 0; t < faces.body.size(); ++t) {
        if (faces.body_label[t] >= 0) continue;
        int& label = of_set[faces.body_set[t]];
        for (int i = 0; i < 3 && label < 0; ++i)
            label = labelAt(body.vertices[faces.body[t][i]], lattice, crack);
        faces.body_label[t] = label;
    }
    // A degenerate first triangle leaves -1 where a later one of the same shell found the label.
    for (std::size_t t = 0; t < faces.body.size(); ++t)
        if (faces.body_label[t] < 0) faces.body_label[t] = of_set[faces.body_set[t]];
    return std::find(faces.body_label.begin(), faces.body_label.end(), -1) == faces.body_label.end();
}

// Keeps the crack faces inside the solid. The values of `inside` are 1 or 0, or -1 for faces that are not
// connected to the body's surface; of each such set one point is located.
void keepInsideCracks(const SplitSurface& split, const SpreadValues& inside, const CrackComplex& crack,
                      const TriangleMesh& body, CutFaces& faces) {
    std::vector<int> of_set(inside.set_count, -1);
    for (std::size_t t = 0; t < split.triangles.size(); ++t) {
        int is_inside = inside.value[t];
        if (is_inside < 0) {
            int& known = of_set[inside.set[t]];
            if (known < 0)
                known = isInside(faces.points[split.triangles[t][0]], body.vertices, body.triangles);
            is_inside = known;
        }
        if (!is_inside) continue;
        faces.crack.push_back(split.triangles[t]);
        faces.crack_sides.push_back(crack.sides[split.parents[t]]);
        if (!crack.smooth_normals.empty())
            faces.smooth_normals.push_back(crack.smooth_normals[split.parents[t]]);
    }
}

std::vector<Triangle> shifted(std::vector<Triangle> triangles, int first) {
    for (Triangle& t : triangles)
        for (int& v : t) v += first;
    return triangles;
}

}  // namespace

CutAttempt cutFaces(const CuttableSurface& surface, const LabelLattice& lattice, const CrackComplex& crack) {
    const TriangleMesh& body = surface.mesh();
    CutAttempt attempt;
    const EdgeTable crack_edges = buildEdgeTable(crack.triangles, static_cast<int>(crack.points.size()));
    SurfaceCrossing crossing = crossSurfaces(surface, lattice, crack, crack_edges);
    attempt.troubled = crossing.degenerate;
    if (!attempt.troubled.empty()) return attempt;

    const std::vector<Triangle> crack_triangles = shifted(crack.triangles, crossing.first_crack_point);
    const CrossedSurface crossed[2] = {
        {body.triangles, surface.edges(), crossing.on_body_edges,
         groupSegments(crossing.segments, &CutSegment::body_triangle, body.triangles.size())},
        {crack_triangles, crack_edges, crossing.on_crack_edges,
         groupSegments(crossing.segments, &CutSegment::crack_triangle, crack.triangles.size())}};
    std::vector<SideValues> values[2];
    for (const CutSegment& s : crossing.segments) {
        values[0].push_back({crack.sides[s.crack_triangle].below, crack.sides[s.crack_triangle].above});
        values[1].push_back({0, 1});  // outside and inside
    }
    SplitSurface split[2];
    std::optional<SpreadValues> spread[2];
    std::vector<int> troubled[2];
    forEachChunk(2, [&](int side) {
        split[side] = splitSurface(crossed[side], crossing, troubled[side]);
        if (troubled[side].empty())
            spread[side] = spreadFromSegments(crossed[side], split[side], values[side]);
    });
    for (const std::vector<int>& crack_triangles_to_blame : troubled)
        attempt.troubled.insert(attempt.troubled.end(), crack_triangles_to_blame.begin(),
                                crack_triangles_to_blame.end());
    if (!attempt.troubled.empty()) return attempt;

    CutFaces& faces = attempt.faces;
    auto& body_labels = spread[0];
    const auto& inside = spread[1];
    if (!body_labels || !inside) {
        attempt.failure = "the lines of the crack on the surface do not close";
        return attempt;
    }
    faces.body_label = std::move(body_labels->value);
    faces.body_set = std::move(body_labels->set);
    faces.body_set_count = body_labels->set_count;
    faces.points = std::move(crossing.points);
    faces.body_point_count = crossing.first_crack_point;
    faces.body = std::move(split[0].triangles);
    faces.body_parent = std::move(split[0].parents);
    if (!labelUntouchedShells(body, lattice, crack, faces)) {
        attempt.failure = "a part of the surface could not be told from its neighbours";
    } else {
        keepInsideCracks(split[1], *inside, crack, body, faces);
    }
    return attempt;
}

}  // namespace sherd
