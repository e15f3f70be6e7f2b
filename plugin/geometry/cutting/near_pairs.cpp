#include "geometry/cutting/near_pairs.h"

#include "geometry/cutting/triangle_box.h"

namespace sherd {

namespace {

class NearPairs {
  public:
    NearPairs(const TriangleMesh& body, const LatticeLayout& layout, const CrackComplex& crack)
        : body_(body), layout_(layout), crack_(crack) {}

    std::vector<NearPair> find() {
        for (std::size_t cell = 0; cell < layout_.active_cells.size(); ++cell)
            if (crack_.first_of_cell[cell] < crack_.first_of_cell[cell + 1] &&
                layout_.first_triangle[cell] < layout_.first_triangle[cell + 1])
                pairWithin(cell);
        return sortedByBodyTriangle();
    }

  private:
    struct Boxed {
        int triangle;
        TriangleBox box;
    };

    // Only triangles of either surface that reach the other one in this cell are compared with each other.
    void pairWithin(std::size_t cell) {
        crack_boxes_.clear();
        near_.clear();
        TriangleBox of_crack, of_near;
        for (int c = crack_.first_of_cell[cell]; c < crack_.first_of_cell[cell + 1]; ++c) {
            crack_boxes_.push_back({c, boxOf(crack_.triangles[c], crack_.points)});
            of_crack.extend(crack_boxes_.back().box);
        }
        for (int k = layout_.first_triangle[cell]; k < layout_.first_triangle[cell + 1]; ++k) {
            const int b = layout_.triangles[k];
            const TriangleBox box = boxOf(body_.triangles[b], body_.vertices);
            if (!box.meets(of_crack)) continue;
            near_.push_back({b, box});
            of_near.extend(box);
        }
        for (const Boxed& c : crack_boxes_) {
            if (!c.box.meets(of_near)) continue;
            for (const Boxed& b : near_)
                if (c.box.meets(b.box)) pairs_.push_back({b.triangle, c.triangle});
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
    const LatticeLayout& layout_;
    const CrackComplex& crack_;
    std::vector<Boxed> crack_boxes_, near_;  // in one cell
    std::vector<NearPair> pairs_;
};

}  // namespace

std::vector<NearPair> findNearPairs(const TriangleMesh& body, const LabelLattice& lattice,
                                    const CrackComplex& crack) {
    return NearPairs(body, *lattice.layout, crack).find();
}

}  // namespace sherd
