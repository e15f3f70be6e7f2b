#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

namespace sherd {

/// Where an edge of one surface goes through a triangle of the other.
struct EdgeCrossing {
    int edge;   ///< in the edge table of the surface that the edge belongs to
    double t;   ///< place on the edge, from its lower vertex
    int point;  ///< in `SurfaceCrossing::points`
    int crack_triangle;
    int other;  ///< the triangle of the other surface
    int next;   ///< the crossing of the same edge that was found before; -1: none
};

/// The crossings of all edges of one surface.
class EdgeCrossings {
  public:
    explicit EdgeCrossings(std::size_t edge_count = 0) : first_(edge_count, -1) {}

    /// The point where an edge crosses a triangle of the other surface, or -1 if that was not added.
    int find(int edge, int other) const {
        for (int k = first_[edge]; k >= 0; k = list_[k].next)
            if (list_[k].other == other) return list_[k].point;
        return -1;
    }

    void add(int edge, int other, double t, int point, int crack_triangle) {
        list_.push_back({edge, t, point, crack_triangle, other, first_[edge]});
        first_[edge] = static_cast<int>(list_.size()) - 1;
    }

    /// Calls visit(crossings) once for every edge that is crossed; they are sorted by place.
    template <class Visit>
    void forEachEdge(const Visit& visit) const {
        std::vector<EdgeCrossing> on_edge;
        for (std::size_t k = 0; k < list_.size(); ++k) {
            if (first_[list_[k].edge] != static_cast<int>(k)) continue;  // another is the edge's last
            collect(list_[k].edge, on_edge);
            visit(on_edge);
        }
    }

    /// Those of one edge, by place.
    void collect(int edge, std::vector<EdgeCrossing>& on_edge) const {
        on_edge.clear();
        for (int k = first_[edge]; k >= 0; k = list_[k].next) on_edge.push_back(list_[k]);
        std::sort(on_edge.begin(), on_edge.end(), [](const EdgeCrossing& a, const EdgeCrossing& b) {
            return std::tie(a.t, a.point) < std::tie(b.t, b.point);
        });
    }

  private:
    std::vector<int> first_;  // #edges, the crossing found last, or -1
    std::vector<EdgeCrossing> list_;
};

}  // namespace sherd
