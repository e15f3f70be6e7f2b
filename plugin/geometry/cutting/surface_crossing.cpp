#include "geometry/cutting/surface_crossing.h"

#include <algorithm>

#include "core/numerics/parallel_chunks.h"
#include "geometry/cutting/exact_orientation.h"
#include "geometry/cutting/near_pairs.h"

namespace sherd {

namespace {

// Least distance of a crossing from a vertex or an edge, relative to the triangle or edge: nearer ones would
// leave needles.
constexpr double smallest_share = 1e-6;

struct Corners {
    const Vec3 &a, &b, &c;
    const Vec3& operator[](int i) const { return i == 0 ? a : i == 1 ? b : c; }
};

Corners cornersOf(const Triangle& t, const std::vector<Vec3>& points) {
    return {points[t[0]], points[t[1]], points[t[2]]};
}

constexpr int next_corner[3] = {1, 2, 0};

class Crossing {
  public:
    Crossing(const CuttableSurface& surface, const CrackComplex& crack, const EdgeTable& crack_edges)
        : body_(surface.mesh()), body_edges_(surface.edges()), crack_(crack), crack_edges_(crack_edges) {
        result_.points.reserve(body_.vertices.size() + crack.points.size() + crack.points.size() / 2);
        result_.points = body_.vertices;
        result_.first_crack_point = static_cast<int>(body_.vertices.size());
        result_.points.insert(result_.points.end(), crack.points.begin(), crack.points.end());
        result_.on_body_edges = EdgeCrossings(body_edges_.edges.size());
        result_.on_crack_edges = EdgeCrossings(crack_edges.edges.size());
    }

    SurfaceCrossing run(const LabelLattice& lattice) {
        const std::vector<NearPair> pairs = findNearPairs(body_, lattice, crack_);
        constexpr int chunk_count = 8;
        std::vector<std::vector<CrossedPair>> crossed(chunk_count);
        forEachChunk(chunk_count, [&](int chunk) {
            const auto first = [&](int k) { return firstOfItsBodyTriangle(pairs, chunk_count, k); };
            crossed[chunk] = crossedPairs(pairs.data() + first(chunk), pairs.data() + first(chunk + 1));
        });
        for (const std::vector<CrossedPair>& some : crossed)
            for (const CrossedPair& pair : some) addSegment(pair);
        findNearCrossings(result_.on_body_edges);
        findNearCrossings(result_.on_crack_edges);
        auto& bad = result_.degenerate;
        std::sort(bad.begin(), bad.end());
        bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
        return std::move(result_);
    }

  private:
    // Signs of the corners of one triangle against the plane of the other; false if all are on one side.
    static bool signsAgainst(const OrientedPlane& plane, const Corners& x, int (&sign)[3]) {
        for (int i = 0; i < 3; ++i) sign[i] = plane.side(x[i]);
        return sign[0] != sign[1] || sign[1] != sign[2] || sign[0] == 0;
    }

    // Two triangles of which neither has all corners on one side of the other.
    struct CrossedPair {
        int body_triangle, crack_triangle;
        int body_sign[3], crack_sign[3];
        int twist[3][3];  // [i][j]: on which side of body edge i crack edge j passes
        bool degenerate;
    };

    // Where the pairs of a chunk begin, if none shares a body triangle with the chunk before.
    static std::size_t firstOfItsBodyTriangle(const std::vector<NearPair>& pairs, int chunk_count,
                                              int chunk) {
        std::size_t first = chunkBegin(chunk, chunk_count, static_cast<int>(pairs.size()));
        while (first > 0 && first < pairs.size() &&
               pairs[first].body_triangle == pairs[first - 1].body_triangle)
            ++first;
        return first;
    }

    std::vector<CrossedPair> crossedPairs(const NearPair* pair, const NearPair* end) const {
        std::vector<CrossedPair> crossed;
        while (pair != end) {
            const int b = pair->body_triangle;
            const Corners x = cornersOf(body_.triangles[b], body_.vertices);
            const OrientedPlane plane(x.a, x.b, x.c);
            for (; pair != end && pair->body_triangle == b; ++pair)
                crossPair(b, x, plane, pair->crack_triangle, crossed);
        }
        return crossed;
    }

    void crossPair(int b, const Corners& x, const OrientedPlane& body_plane, int c,
                   std::vector<CrossedPair>& crossed) const {
        const Corners y = cornersOf(crack_.triangles[c], crack_.points);
        CrossedPair pair{b, c, {}, {}, {}, false};
        if (!signsAgainst(body_plane, y, pair.crack_sign) ||
            !signsAgainst(OrientedPlane(y.a, y.b, y.c), x, pair.body_sign))
            return;
        for (int i = 0; i < 3; ++i) {
            pair.degenerate |= pair.body_sign[i] == 0 || pair.crack_sign[i] == 0;
            for (int j = 0; j < 3; ++j) {
                pair.twist[i][j] = OrientedPlane(x[i], x[next_corner[i]], y[j]).side(y[next_corner[j]]);
                pair.degenerate |= pair.twist[i][j] == 0;
            }
        }
        crossed.push_back(pair);
    }

    void addSegment(const CrossedPair& pair) {
        const auto& [b, c, body_sign, crack_sign, twist, degenerate] = pair;
        if (degenerate) return result_.degenerate.push_back(c);
        const Corners x = cornersOf(body_.triangles[b], body_.vertices);
        const Corners y = cornersOf(crack_.triangles[c], crack_.points);
        CutSegment segment = {-1, -1, b, c};
        for (int i = 0; i < 3; ++i)
            if (body_sign[i] != body_sign[next_corner[i]] && twist[i][0] == twist[i][1] &&
                twist[i][1] == twist[i][2])
                (body_sign[i] > 0 ? segment.target : segment.source) =
                    bodyEdgeCrossing(body_edges_.of_triangle[b][i], y, c);
        for (int j = 0; j < 3; ++j)
            if (crack_sign[j] != crack_sign[next_corner[j]] && twist[0][j] == twist[1][j] &&
                twist[1][j] == twist[2][j])
                (crack_sign[j] > 0 ? segment.source : segment.target) =
                    crackEdgeCrossing(crack_edges_.of_triangle[c][j], x, b, c);
        if (segment.source >= 0 && segment.target >= 0) result_.segments.push_back(segment);
    }

    int bodyEdgeCrossing(int edge, const Corners& crack_corners, int c) {
        if (const int known = result_.on_body_edges.find(edge, c); known >= 0) return known;
        const auto [low, high] = body_edges_.edges[edge];
        const double t = addPoint(body_.vertices[low], body_.vertices[high], crack_corners, c);
        return keep(result_.on_body_edges, edge, c, t, c);
    }

    int crackEdgeCrossing(int edge, const Corners& body_corners, int b, int c) {
        if (const int known = result_.on_crack_edges.find(edge, b); known >= 0) return known;
        const auto [low, high] = crack_edges_.edges[edge];
        const double t = addPoint(crack_.points[low], crack_.points[high], body_corners, c);
        return keep(result_.on_crack_edges, edge, b, t, c);
    }

    int keep(EdgeCrossings& crossings, int edge, int other, double t, int crack_triangle) const {
        const int point = static_cast<int>(result_.points.size()) - 1;
        crossings.add(edge, other, t, point, crack_triangle);
        return point;
    }

    // The place on the edge from p to q where it crosses the plane; the point there is added.
    double addPoint(const Vec3& p, const Vec3& q, const Corners& plane, int crack_triangle) {
        const double at_p = signedVolume(plane.a, plane.b, plane.c, p),
                     at_q = signedVolume(plane.a, plane.b, plane.c, q);
        const double t = at_p / (at_p - at_q);
        bool safe = t > smallest_share && t < 1 - smallest_share;
        double share[3], sum = 0;
        for (int j = 0; j < 3; ++j) sum += share[j] = signedVolume(p, q, plane[j], plane[next_corner[j]]);
        for (double s : share) safe = safe && s / sum > smallest_share;
        if (!safe) result_.degenerate.push_back(crack_triangle);
        result_.points.push_back(t < 0.5 ? Vec3(p + t * (q - p))
                                         : Vec3(q + (at_q / (at_q - at_p)) * (p - q)));
        return t;
    }

    // Crossings of one edge that are too near to each other.
    void findNearCrossings(const EdgeCrossings& crossings) {
        crossings.forEachEdge([&](const std::vector<EdgeCrossing>& list) {
            for (std::size_t k = 1; k < list.size(); ++k)
                if (list[k].t - list[k - 1].t < smallest_share)
                    result_.degenerate.push_back(list[k].crack_triangle);
        });
    }

    const TriangleMesh& body_;
    const EdgeTable& body_edges_;
    const CrackComplex& crack_;
    const EdgeTable& crack_edges_;
    SurfaceCrossing result_;
};

}  // namespace

SurfaceCrossing crossSurfaces(const CuttableSurface& body, const LabelLattice& lattice,
                              const CrackComplex& crack, const EdgeTable& crack_edges) {
    return Crossing(body, crack, crack_edges).run(lattice);
}

}  // namespace sherd
