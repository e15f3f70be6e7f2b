#include "geometry/cutting/near_pairs.h"

#include <algorithm>
#include <array>

namespace sherd {

namespace {

/// A lattice cell with crack triangles, which follow each other.
struct CrackCell {
    int begin, end;   // of its triangles
    TriangleBox box;  // of them
};

class NearPairs {
  public:
    NearPairs(const CuttableSurface& body, const LabelLattice& lattice, const CrackComplex& crack)
        : body_(body.mesh()), boxes_of_runs_(body.boxesOfRuns()), lattice_(lattice) {
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
        const int count = static_cast<int>(body_.triangles.size());
        in_cells_count_.assign(cells_.size() + 1, 0);
        for (std::size_t run = 0; run < boxes_of_runs_.size(); ++run) {
            if (!reachesCrack(boxes_of_runs_[run])) continue;
            const int begin = static_cast<int>(run) * CuttableSurface::run_length,
                      end = std::min(begin + CuttableSurface::run_length, count);
            for (int b = begin; b < end; ++b) findCells(b);
        }
        std::vector<int>& next = in_cells_count_;
        for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
        first_in_cell_ = next;
        in_cell_.resize(found_.size());
        for (const InCell& entry : found_) in_cell_[next[entry.cell]++] = entry.body_triangle;
    }

    bool reachesCrack(const TriangleBox& box) {
        look(box);
        return std::any_of(near_cells_.begin(), near_cells_.end(),
                           [&](int cell) { return cells_[cell].box.meets(box); });
    }

    void findCells(int body_triangle) {
        const TriangleBox box = boxOf(body_.triangles[body_triangle], body_.vertices);
        look(box);
        for (const int cell : near_cells_) {
            if (!cells_[cell].box.meets(box)) continue;
            found_.push_back({cell, body_triangle});
            ++in_cells_count_[cell + 1];
        }
    }

    // The neighbours of a small triangle come soon after it, and often mean the same cells.
    void look(const TriangleBox& box) {
        const Range own = rangeOf(box);
        if (own == range_) return;
        range_ = own;
        collectCells(range_, near_cells_);
    }

    // The cells that may hold cracks which meet a box.
    Range rangeOf(const TriangleBox& box) const {
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
        TriangleBox surface;
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
    const std::vector<TriangleBox>& boxes_of_runs_;
    const LabelLattice& lattice_;
    std::vector<TriangleBox> crack_boxes_;
    std::vector<CrackCell> cells_;
    std::vector<int> first_cell_;                 // #nodes + 1, offsets into `cells_`
    std::vector<int> first_in_cell_, in_cell_;    // body triangles in each cell
    Range range_ = {{-1, -1, -1}, {-1, -1, -1}};  // looked at last
    std::vector<int> near_cells_;                 // in it
    std::vector<InCell> found_;
    std::vector<int> in_cells_count_;
    std::vector<TriangleBox> near_;
    std::vector<NearPair> pairs_;
};

}  // namespace

std::vector<NearPair> findNearPairs(const CuttableSurface& body, const LabelLattice& lattice,
                                    const CrackComplex& crack) {
    return NearPairs(body, lattice, crack).find();
}

}  // namespace sherd
