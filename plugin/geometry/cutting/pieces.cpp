#include "geometry/cutting/pieces.h"

#include <numeric>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/parallel_chunks.h"
#include "geometry/cutting/hooked_pieces.h"
#include "geometry/cutting/piece_shells.h"
#include "geometry/cutting/stray_pieces.h"

namespace sherd {

namespace {

constexpr int extraction_chunks = 2;

// The surface of one piece. `new_index`: scratch memory, #points, all -1 before and after.
FragmentSurface extract(const PieceShell& shell, const LabelBoundary& boundary, const TriangleMesh& body,
                        const CutFaces& faces, const std::vector<int>& piece_of,
                        std::vector<int>& new_index) {
    FragmentSurface piece;
    piece.label = shell.label;
    piece.merged_labels = shell.merged_labels;
    piece.mesh.vertices.reserve(shell.triangles.size() / 2 + 2);
    piece.mesh.triangles.reserve(shell.triangles.size());
    piece.mesh.kinds.reserve(shell.triangles.size());
    piece.parents.reserve(shell.triangles.size());
    piece.across.reserve(shell.triangles.size());
    for (int t : shell.triangles) {
        Triangle triangle = boundary.triangles[t];
        for (int& v : triangle) {
            if (new_index[v] < 0) {
                new_index[v] = static_cast<int>(piece.mesh.vertices.size());
                piece.mesh.vertices.push_back(faces.points[v]);
            }
            v = new_index[v];
        }
        const int parent = t < boundary.body_count ? faces.body_parent[t] : -1;
        piece.mesh.triangles.push_back(triangle);
        piece.parents.push_back(parent);
        piece.across.push_back(parent < 0 ? piece_of[boundary.opposite(t)] : -1);
        piece.mesh.kinds.push_back(parent < 0           ? SurfaceKind::crack
                                   : body.kinds.empty() ? SurfaceKind::original
                                                        : body.kinds[parent]);
    }
    for (int t : shell.triangles)
        for (int v : boundary.triangles[t]) new_index[v] = -1;
    return piece;
}

}  // namespace

Result<std::vector<FragmentSurface>> assemblePieces(const TriangleMesh& body, const CutFaces& faces,
                                                    const Discretisation& solid, const FragmentLabels& labels,
                                                    const PieceLimits& limits) {
    const LabelBoundary boundary = labelBoundary(faces);
    auto found = pieceShells(boundary, faces, body.vertices.front());
    if (!found) return Error{found.error()};
    std::vector<PieceShell> shells = std::move(found).value();
    mergeStrayPieces(boundary, faces.points, solid, labels, limits, shells);
    if (labels.cracks) mergeHookedPieces(boundary, faces, shells);

    for (const PieceShell& shell : shells)
        if (!(shell.volume > 0)) return Error{"a fragment would have no volume"};
    std::vector<FragmentSurface> pieces(shells.size());
    const std::vector<int> piece_of = pieceOfTriangle(shells, boundary);
    forEachChunk(extraction_chunks, [&](int chunk) {
        std::vector<int> new_index(faces.points.size(), -1);
        for (std::size_t s = chunk; s < shells.size(); s += extraction_chunks)
            pieces[s] = extract(shells[s], boundary, body, faces, piece_of, new_index);
    });
    return pieces;
}

double volumeRatio(const TriangleMesh& body, const std::vector<FragmentSurface>& pieces) {
    const Vec3& origin = body.vertices.front();
    std::vector<double> volumes(pieces.size() + 1);
    forEachChunk(static_cast<int>(volumes.size()), [&](int i) {
        const TriangleMesh& mesh = i == 0 ? body : pieces[i - 1].mesh;
        volumes[i] = enclosedVolume(mesh.vertices, mesh.triangles, origin);
    });
    return std::accumulate(volumes.begin() + 1, volumes.end(), 0.0) / volumes[0];
}

}  // namespace sherd
