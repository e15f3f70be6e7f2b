#include "geometry/cutting/near_pairs.h"

#include <array>
#include <limits>

namespace sherd {

namespace {

struct Box {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;

    void extend(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    bool meets(const Box& other) const {
        return low.x() <= other.high.x() && high.x() >= other.low.x() && low.y() <= other.high.y() &&
               high.y() >= other.low.y() && low.z() <= other.high.z() && high.z() >= other.low.z();
    }
};

Box boxOf(const Triangle& t, const std::vector<Vec3>& points) {
    const Vec3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    Box box;
    box.low = a.cwiseMin(b).cwiseMin(c);
    box.high = a.cwiseMax(b).cwiseMax(c);
    return box;
}

/// A lattice cell with crack triangles, which follow each other.
struct CrackCell {
    int begin, end;  // of its triangles
    Box box;         // of them
};

class NearPairs {
  public:
    NearPairs(const TriangleMesh& body, const LabelLattice& lattice, const CrackComplex& crack)
        : body_(body), lattice_(lattice) {
        crack_boxes_.reserve(crack.triangles.size());
        for (const Triangle& t : crack.triangles) crack_boxes_.push_back(boxOf(t, crack.points));
        first_cell_.resize(crack.first_of_cell.size());
        for (std::size_t c = 0; c + 1 < crack.first_of_cell.size(); ++c) {
            first_cell_[c] = static_cast<int>(cells_.size());
            const int begin = crack.first_of_cell[c], end = crack.first_of_cell[c + 1];
            if (begin == end) continue;
            cells_.push_back({begin, end, {}});
            for (int t = begin; t < end; ++t) cells_.back().box.extend(crack_boxes_[t]);
        }
        first_cell_.back() = static_cast<int>(cells_.size());
    }

    std::vector<NearPair> find() {
        sortBodyIntoCells();
        for (std::size_t cell = 0; cell < cells_.size(); ++cell) pairWithin(static_cast<int>(cell));
        return sortedByBodyTriangle();
    }

  private:
    struct InCell {
        int cell, body_triangle;
    };

    // Cells from the first to the last along each axis.
    struct Range {
        std::array<int, 3> first, last;
        bool operator==(const Range& other) const { return first == other.first && last == other.last; }
    };

    void sortBodyIntoCells() {
        std::vector<InCell> found;
        std::vector<int> count(cells_.size() + 1, 0), near_cells;
        Range range = {{-1, -1, -1}, {-1, -1, -1}};
        for (int b = 0; b < static_cast<int>(body_.triangles.size()); ++b) {
            const Box box = boxOf(body_.triangles[b], body_.vertices);
            // The neighbours of a small triangle come soon after it, and often mean the same cells.
            if (const Range own = rangeOf(box); !(own == range)) {
                range = own;
                collectCells(range, near_cells);
            }
            for (const int cell : near_cells) {
                if (!cells_[cell].box.meets(box)) continue;
                found.push_back({cell, b});
                ++count[cell + 1];
            }
        }
        for (std::size_t c = 1; c < count.size(); ++c) count[c] += count[c - 1];
        first_in_cell_ = count;
        in_cell_.resize(found.size());
        for (const InCell& entry : found) in_cell_[count[entry.cell]++] = entry.body_triangle;
    }

    // The cells that may hold cracks which meet a box.
    Range rangeOf(const Box& box) const {
        // Nodes are jittered, so a cell reaches beyond its place on the grid. The lattice begins in the air
        // below the solid, so all of this is positive and truncation rounds down.
        const double reach = lattice_.jitter + 1e-6, cells_per_m = 1 / lattice_.spacing;
        Range range;
        for (int d = 0; d < 3; ++d) {
            range.first[d] = static_cast<int>((box.low[d] - lattice_.origin[d]) * cells_per_m - reach);
            range.last[d] = static_cast<int>((box.high[d] - lattice_.origin[d]) * cells_per_m + reach);
        }
        return range;
    }

    void collectCells(const Range& range, std::vector<int>& cells) const {
        cells.clear();
        for (int k = range.first[2]; k <= range.last[2]; ++k)
            for (int j = range.first[1]; j <= range.last[1]; ++j) {
                const int end = first_cell_[lattice_.index(range.last[0], j, k) + 1];
                for (int cell = first_cell_[lattice_.index(range.first[0], j, k)]; cell < end; ++cell)
                    cells.push_back(cell);
            }
    }

    // Only crack triangles that reach the surface in this cell are compared with each of its triangles.
    void pairWithin(int cell) {
        if (first_in_cell_[cell] == first_in_cell_[cell + 1]) return;
        near_.clear();
        Box surface;
        for (int k = first_in_cell_[cell]; k < first_in_cell_[cell + 1]; ++k) {
            near_.push_back(boxOf(body_.triangles[in_cell_[k]], body_.vertices));
            surface.extend(near_.back());
        }
        for (int c = cells_[cell].begin; c < cells_[cell].end; ++c) {
            if (!crack_boxes_[c].meets(surface)) continue;
            for (std::size_t k = 0; k < near_.size(); ++k)
                if (crack_boxes_[c].meets(near_[k]))
                    pairs_.push_back({in_cell_[first_in_cell_[cell] + k], c});
        }
    }

    // The pairs come by crack triangle; a stable sort by the other leaves them in that order.
    std::vector<NearPair> sortedByBodyTriangle() const {
        std::vector<int> next(body_.triangles.size() + 1, 0);
        for (const NearPair& pair : pairs_) ++next[pair.body_triangle + 1];
        for (std::size_t b = 1; b < next.size(); ++b) next[b] += next[b - 1];
        std::vector<NearPair> sorted(pairs_.size());
        for (const NearPair& pair : pairs_) sorted[next[pair.body_triangle]++] = pair;
        return sorted;
    }

    const TriangleMesh& body_;
    const LabelLattice& lattice_;
    std::vector<Box> crack_boxes_;
    std::vector<CrackCell> cells_;
    std::vector<int> first_cell_;               // #nodes + 1, offsets into `cells_`
    std::vector<int> first_in_cell_, in_cell_;  // body triangles in each cell
    std::vector<Box> near_;
    std::vector<NearPair> pairs_;
};

}  // namespace

std::vector<NearPair> findNearPairs(const TriangleMesh& body, const LabelLattice& lattice,
                                    const CrackComplex& crack) {
    return NearPairs(body, lattice, crack).find();
}

}  // namespace sherd
