#include "geometry/cutting/surface_crossing.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "geometry/cutting/exact_orientation.h"
#include "geometry/cutting/triangle_grid.h"

namespace sherd {

namespace {

// Least distance of a crossing from a vertex or an edge, relative to the triangle or edge: nearer ones would
// leave needles.
constexpr double smallest_share = 1e-6;

class Crossing {
  public:
    Crossing(const TriangleMesh& body, const EdgeTable& body_edges, const CrackComplex& crack,
             const EdgeTable& crack_edges)
        : body_(body), body_edges_(body_edges), crack_(crack), crack_edges_(crack_edges) {
        result_.points = body.vertices;
        result_.first_crack_point = static_cast<int>(body.vertices.size());
        result_.points.insert(result_.points.end(), crack.points.begin(), crack.points.end());
    }

    SurfaceCrossing run() {
        const TriangleGrid grid(crack_.points, crack_.triangles);
        std::vector<int> near;
        for (int b = 0; b < static_cast<int>(body_.triangles.size()); ++b) {
            const auto [p, q, r] = corners(b, body_.vertices, body_.triangles);
            near.clear();
            grid.findNear(p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r), near);
            for (int c : near) crossPair(b, c);
        }
        sortByEdge(result_.on_body_edges);
        sortByEdge(result_.on_crack_edges);
        auto& bad = result_.degenerate;
        std::sort(bad.begin(), bad.end());
        bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
        return std::move(result_);
    }

  private:
    static std::array<Vec3, 3> corners(int t, const std::vector<Vec3>& points,
                                       const std::vector<Triangle>& triangles) {
        return {points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]};
    }

    // Signs of the corners of one triangle against the plane of the other; false if all are on one side.
    bool signsAgainst(const std::array<Vec3, 3>& plane, const std::array<Vec3, 3>& x, int (&sign)[3]) const {
        for (int i = 0; i < 3; ++i) sign[i] = orientation(plane[0], plane[1], plane[2], x[i]);
        return sign[0] != sign[1] || sign[1] != sign[2] || sign[0] == 0;
    }

    void crossPair(int b, int c) {
        const auto x = corners(b, body_.vertices, body_.triangles),
                   y = corners(c, crack_.points, crack_.triangles);
        int body_sign[3], crack_sign[3];
        if (!signsAgainst(y, x, body_sign) || !signsAgainst(x, y, crack_sign)) return;
        // twist[i][j]: on which side of body edge i crack edge j passes.
        int twist[3][3];
        bool zero = false;
        for (int i = 0; i < 3; ++i) {
            zero |= body_sign[i] == 0 || crack_sign[i] == 0;
            for (int j = 0; j < 3; ++j) {
                twist[i][j] = orientation(x[i], x[(i + 1) % 3], y[j], y[(j + 1) % 3]);
                zero |= twist[i][j] == 0;
            }
        }
        if (zero) return result_.degenerate.push_back(c);
        CutSegment segment = {-1, -1, b, c};
        for (int i = 0; i < 3; ++i)
            if (body_sign[i] != body_sign[(i + 1) % 3] && twist[i][0] == twist[i][1] &&
                twist[i][1] == twist[i][2])
                (body_sign[i] > 0 ? segment.target : segment.source) =
                    bodyEdgeCrossing(body_edges_.of_triangle[b][i], c);
        for (int j = 0; j < 3; ++j)
            if (crack_sign[j] != crack_sign[(j + 1) % 3] && twist[0][j] == twist[1][j] &&
                twist[1][j] == twist[2][j])
                (crack_sign[j] > 0 ? segment.source : segment.target) =
                    crackEdgeCrossing(crack_edges_.of_triangle[c][j], b, c);
        if (segment.source >= 0 && segment.target >= 0) result_.segments.push_back(segment);
    }

    int bodyEdgeCrossing(int edge, int c) {
        const auto [entry, is_new] = body_edge_points_.try_emplace(key(edge, c), -1);
        if (is_new) {
            const auto [low, high] = body_edges_.edges[edge];
            entry->second = addCrossing(result_.on_body_edges, edge, body_.vertices[low],
                                        body_.vertices[high], corners(c, crack_.points, crack_.triangles), c);
        }
        return entry->second;
    }

    int crackEdgeCrossing(int edge, int b, int c) {
        const auto [entry, is_new] = crack_edge_points_.try_emplace(key(edge, b), -1);
        if (is_new) {
            const auto [low, high] = crack_edges_.edges[edge];
            entry->second = addCrossing(result_.on_crack_edges, edge, crack_.points[low], crack_.points[high],
                                        corners(b, body_.vertices, body_.triangles), c);
        }
        return entry->second;
    }

    int addCrossing(std::vector<EdgeCrossing>& list, int edge, const Vec3& p, const Vec3& q,
                    const std::array<Vec3, 3>& plane, int crack_triangle) {
        const double at_p = signedVolume(plane[0], plane[1], plane[2], p),
                     at_q = signedVolume(plane[0], plane[1], plane[2], q);
        const double t = at_p / (at_p - at_q);
        bool safe = t > smallest_share && t < 1 - smallest_share;
        double share[3], sum = 0;
        for (int j = 0; j < 3; ++j) sum += share[j] = signedVolume(p, q, plane[j], plane[(j + 1) % 3]);
        for (double s : share) safe = safe && s / sum > smallest_share;
        if (!safe) result_.degenerate.push_back(crack_triangle);
        const int point = static_cast<int>(result_.points.size());
        result_.points.push_back(t < 0.5 ? Vec3(p + t * (q - p))
                                         : Vec3(q + (at_q / (at_q - at_p)) * (p - q)));
        list.push_back({edge, t, point, crack_triangle});
        return point;
    }

    void sortByEdge(std::vector<EdgeCrossing>& list) {
        std::sort(list.begin(), list.end(), [](const EdgeCrossing& a, const EdgeCrossing& b) {
            return std::tie(a.edge, a.t, a.point) < std::tie(b.edge, b.t, b.point);
        });
        for (std::size_t k = 1; k < list.size(); ++k)
            if (list[k].edge == list[k - 1].edge && list[k].t - list[k - 1].t < smallest_share)
                result_.degenerate.push_back(list[k].crack_triangle);
    }

    static std::uint64_t key(int edge, int triangle) {
        return static_cast<std::uint64_t>(edge) << 32 | static_cast<std::uint32_t>(triangle);
    }

    const TriangleMesh& body_;
    const EdgeTable& body_edges_;
    const CrackComplex& crack_;
    const EdgeTable& crack_edges_;
    SurfaceCrossing result_;
    // For look-up only: points are numbered in the order in which triangles are visited.
    std::unordered_map<std::uint64_t, int> body_edge_points_, crack_edge_points_;
};

}  // namespace

SurfaceCrossing crossSurfaces(const TriangleMesh& body, const EdgeTable& body_edges,
                              const CrackComplex& crack, const EdgeTable& crack_edges) {
    return Crossing(body, body_edges, crack, crack_edges).run();
}

}  // namespace sherd
