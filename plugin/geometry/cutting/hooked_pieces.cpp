#include "geometry/cutting/hooked_pieces.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/clustering/way_out.h"
#include "core/numerics/fibonacci_sphere.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/parallel_chunks.h"
#include "core/numerics/union_find.h"
#include "geometry/cutting/stray_pieces.h"

namespace sherd {

namespace {

constexpr double most_in_the_way = 0.04;  // of the crack area
constexpr int directions = 400;

/// A crack face of a piece.
struct Face {
    Vec3 normal;  // outward, unit
    double area;
    int triangle;
};

/// Looks at every sixteenth face first: neighbours face alike, and most ways are soon found to be barred.
bool isFree(const std::vector<Face>& faces, double allowed, const Vec3& direction) {
    constexpr std::size_t step = 16;
    for (std::size_t first = 0; first < step; ++first)
        for (std::size_t f = first; f < faces.size(); f += step) {
            if (faces[f].normal.dot(direction) > most_facing) allowed -= faces[f].area;
            if (allowed < 0) return false;
        }
    return true;
}

/// Tries the ways out that most pieces have first: away from the cracks, and along a wall.
bool isHooked(const std::vector<Face>& faces) {
    if (faces.empty()) return false;
    double all = 0;
    Vec3 sum = Vec3::Zero();
    Mat3 facing = Mat3::Zero();
    for (const Face& face : faces) {
        all += face.area;
        sum += face.area * face.normal;
        facing += face.area * face.normal * face.normal.transpose();
    }
    const double allowed = most_in_the_way * all;
    const auto free = [&](const Vec3& direction) { return isFree(faces, allowed, direction); };
    const Vec3 along = Eigen::SelfAdjointEigenSolver<Mat3>(facing).eigenvectors().col(0);
    if (free(-sum.normalized()) || free(along) || free(-along)) return false;
    for (int k = 0; k < directions; ++k)
        if (free(fibonacciDirection(k, directions))) return false;
    return true;
}

class Merging {
  public:
    Merging(const LabelBoundary& boundary, const CutFaces& cut, const std::vector<PieceShell>& shells)
        : boundary_(boundary),
          shells_(shells),
          piece_of_(pieceOfTriangle(shells, boundary)),
          faces_(shells.size()),
          merged_(shells.size()) {
        for (std::size_t s = 0; s < shells.size(); ++s)
            for (const int t : shells[s].triangles) {
                if (t < boundary.body_count) continue;
                const auto& [a, b, c] = boundary.triangles[t];
                const Vec3 area = areaVector({cut.points[a], cut.points[b], cut.points[c]});
                if (!(area.norm() > 0)) continue;
                const Vec3 normal = cut.smooth_normals.empty() ? area.normalized() : smoothNormal(cut, t);
                faces_[s].push_back({normal, area.norm(), t});
            }
    }

    std::vector<int> run() {
        std::vector<int> order(shells_.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return shells_[a].volume < shells_[b].volume; });
        hooked_.resize(shells_.size());
        forEachChunk(static_cast<int>(shells_.size()), [&](int s) { hooked_[s] = isHooked(faces_[s]); });
        const auto is_left = [&](int s) { return hooked_[s] && merged_.isRoot(s); };
        while (std::any_of(order.begin(), order.end(), is_left))
            for (const int s : order)
                if (is_left(s)) mergeIntoNeighbour(s);
        return merged_.roots();
    }

  private:
    /// Outward. Of both sides of a face the lower one comes first.
    Vec3 smoothNormal(const CutFaces& cut, int triangle) const {
        const int side = triangle - boundary_.body_count;
        return side % 2 == 0 ? cut.smooth_normals[side / 2] : -cut.smooth_normals[side / 2];
    }

    int across(const Face& face) { return merged_.root(piece_of_[boundary_.opposite(face.triangle)]); }

    /// Faces between what is one piece by now.
    void dropInner(int piece) {
        std::vector<Face>& faces = faces_[piece];
        faces.erase(std::remove_if(faces.begin(), faces.end(),
                                   [&](const Face& face) { return across(face) == piece; }),
                    faces.end());
    }

    void mergeIntoNeighbour(int piece) {
        std::map<int, double> areas;
        for (const Face& face : faces_[piece]) areas[across(face)] += face.area;
        const auto most = std::max_element(areas.begin(), areas.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        merged_.uniteInto(most->first, piece);
        faces_[most->first].insert(faces_[most->first].end(), faces_[piece].begin(), faces_[piece].end());
        dropInner(most->first);
        hooked_[most->first] = isHooked(faces_[most->first]);
    }

    const LabelBoundary& boundary_;
    const std::vector<PieceShell>& shells_;
    std::vector<int> piece_of_;
    std::vector<std::vector<Face>> faces_;  // #shells
    std::vector<char> hooked_;              // #shells
    UnionFind merged_;
};

}  // namespace

void mergeHookedPieces(const LabelBoundary& boundary, const CutFaces& faces,
                       std::vector<PieceShell>& shells) {
    mergeShells(Merging(boundary, faces, shells).run(), boundary, shells);
}

}  // namespace sherd
