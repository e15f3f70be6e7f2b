#include "geometry/cutting/split_surface.h"

#include <algorithm>
#include <utility>

#include "geometry/cutting/triangle_subdivision.h"

namespace sherd {

namespace {

class Splitting {
  public:
    Splitting(const CrossedSurface& surface, const SurfaceCrossing& crossing)
        : surface_(surface), crossing_(crossing) {
        const std::size_t count = surface.triangles.size(), most = count + 6 * crossing.segments.size();
        result_.triangles.reserve(most);
        result_.parents.reserve(most);
        result_.patches.reserve(most);
        result_.crossed.assign(count, -1);
        result_.patch_count = static_cast<int>(count);
        result_.beside_segments.resize(crossing.segments.size(), {-1, -1});
    }

    SplitSurface run(std::vector<int>& troubled) {
        for (int t = 0; t < static_cast<int>(surface_.triangles.size()); ++t) {
            if (surface_.groups.isEmpty(t))
                add(surface_.triangles[t], t, t);
            else if (!split(t))
                for (int k = surface_.groups.first[t]; k < surface_.groups.first[t + 1]; ++k)
                    troubled.push_back(crossing_.segments[surface_.groups.segments[k]].crack_triangle);
        }
        result_.first_side.push_back(static_cast<int>(result_.along_sides.size()));
        return std::move(result_);
    }

  private:
    void add(const Triangle& triangle, int parent, int patch) {
        result_.triangles.push_back(triangle);
        result_.parents.push_back(parent);
        result_.patches.push_back(patch);
    }

    bool split(int t) {
        const int* const begin = surface_.groups.segments.data() + surface_.groups.first[t];
        const int* const end = surface_.groups.segments.data() + surface_.groups.first[t + 1];
        pairs_.clear();
        for (const int* s = begin; s != end; ++s)
            pairs_.emplace_back(crossing_.segments[*s].source, crossing_.segments[*s].target);
        collectLoop(t);
        const std::vector<Vec3>& x = crossing_.points;
        const auto& [a, b, c] = surface_.triangles[t];
        parts_.clear();
        if (!subdivision_.split(x, (x[b] - x[a]).cross(x[c] - x[a]), loop_, pairs_, parts_, polygons_))
            return false;
        const int first = result_.patch_count;
        for (std::size_t p = 0; p < parts_.size(); ++p) add(parts_[p], t, first + polygons_.of_part[p]);
        for (std::size_t s = 0; s < pairs_.size(); ++s)
            for (int side = 0; side < 2; ++side)
                result_.beside_segments[begin[s]][side] = first + polygons_.beside_segments[s][side];
        for (const int polygon : polygons_.at_edge) result_.along_sides.push_back(first + polygon);
        result_.patch_count += polygons_.count;
        return true;
    }

    /// Corners of a triangle and crossings along its edges, counter-clockwise.
    void collectLoop(int triangle) {
        const auto sides_before = static_cast<int>(result_.along_sides.size());
        result_.crossed[triangle] = static_cast<int>(result_.first_side.size() / 3);
        loop_.clear();
        for (int i = 0; i < 3; ++i) {
            result_.first_side.push_back(sides_before + static_cast<int>(loop_.size()));
            surface_.on_edges.collect(surface_.edges.of_triangle[triangle][i], crossings_);
            loop_.push_back(surface_.triangles[triangle][i]);
            const auto first = static_cast<long>(loop_.size());
            for (const EdgeCrossing& crossing : crossings_) loop_.push_back(crossing.point);
            const bool from_lower =
                surface_.triangles[triangle][i] < surface_.triangles[triangle][(i + 1) % 3];
            if (!from_lower) std::reverse(loop_.begin() + first, loop_.end());
        }
    }

    const CrossedSurface& surface_;
    const SurfaceCrossing& crossing_;
    SplitSurface result_;
    TriangleSubdivision subdivision_;
    TrianglePolygons polygons_;
    std::vector<std::pair<int, int>> pairs_;
    std::vector<int> loop_;
    std::vector<EdgeCrossing> crossings_;  // along one edge
    std::vector<Triangle> parts_;          // of one triangle
};

}  // namespace

SegmentGroups groupSegments(const std::vector<CutSegment>& segments, int CutSegment::*triangle,
                            std::size_t count) {
    SegmentGroups groups;
    groups.first.assign(count + 1, 0);
    for (const CutSegment& s : segments) ++groups.first[s.*triangle + 1];
    for (std::size_t t = 1; t <= count; ++t) groups.first[t] += groups.first[t - 1];
    groups.segments.resize(segments.size());
    std::vector<int> next(groups.first.begin(), groups.first.end() - 1);
    for (std::size_t s = 0; s < segments.size(); ++s)
        groups.segments[next[segments[s].*triangle]++] = static_cast<int>(s);
    return groups;
}

SplitSurface splitSurface(const CrossedSurface& surface, const SurfaceCrossing& crossing,
                          std::vector<int>& troubled) {
    return Splitting(surface, crossing).run(troubled);
}

}  // namespace sherd
