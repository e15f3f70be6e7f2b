#include "geometry/cutting/near_pairs.h"

#include "core/numerics/parallel_chunks.h"
#include "geometry/cutting/triangle_box.h"

namespace sherd {

namespace {

class NearPairs {
  public:
    NearPairs(const TriangleMesh& body, const LatticeLayout& layout, const CrackComplex& crack)
        : body_(body), layout_(layout), crack_(crack) {}

    std::vector<NearPair> find() const {
        constexpr int chunk_count = 8;
        const int cell_count = static_cast<int>(layout_.active_cells.size());
        std::vector<std::vector<NearPair>> found(chunk_count);
        forEachChunk(chunk_count, [&](int chunk) {
            OneCell scratch;
            const int end = chunkBegin(chunk + 1, chunk_count, cell_count);
            for (int cell = chunkBegin(chunk, chunk_count, cell_count); cell < end; ++cell)
                if (crack_.first_of_cell[cell] < crack_.first_of_cell[cell + 1] &&
                    layout_.first_triangle[cell] < layout_.first_triangle[cell + 1])
                    pairWithin(cell, scratch, found[chunk]);
        });
        return sortedByBodyTriangle(found);
    }

  private:
    struct Boxed {
        int triangle;
        TriangleBox box;
    };
    struct OneCell {
        std::vector<Boxed> crack, near;
    };

    // Only triangles of either surface that reach the other one in this cell are compared with each other.
    void pairWithin(int cell, OneCell& boxes, std::vector<NearPair>& pairs) const {
        boxes.crack.clear();
        boxes.near.clear();
        TriangleBox of_crack, of_near;
        for (int c = crack_.first_of_cell[cell]; c < crack_.first_of_cell[cell + 1]; ++c) {
            boxes.crack.push_back({c, boxOf(crack_.triangles[c], crack_.points)});
            of_crack.extend(boxes.crack.back().box);
        }
        for (int k = layout_.first_triangle[cell]; k < layout_.first_triangle[cell + 1]; ++k) {
            const int b = layout_.triangles[k];
            const TriangleBox box = boxOf(body_.triangles[b], body_.vertices);
            if (!box.meets(of_crack)) continue;
            boxes.near.push_back({b, box});
            of_near.extend(box);
        }
        for (const Boxed& c : boxes.crack) {
            if (!c.box.meets(of_near)) continue;
            for (const Boxed& b : boxes.near)
                if (c.box.meets(b.box)) pairs.push_back({b.triangle, c.triangle});
        }
    }

    // The pairs come by crack triangle; a stable sort by the other leaves them in that order.
    std::vector<NearPair> sortedByBodyTriangle(const std::vector<std::vector<NearPair>>& found) const {
        std::vector<int> next(body_.triangles.size() + 1, 0);
        for (const std::vector<NearPair>& pairs : found)
            for (const NearPair& pair : pairs) ++next[pair.body_triangle + 1];
        for (std::size_t b = 1; b < next.size(); ++b) next[b] += next[b - 1];
        std::vector<NearPair> sorted(next.back());
        for (const std::vector<NearPair>& pairs : found)
            for (const NearPair& pair : pairs) sorted[next[pair.body_triangle]++] = pair;
        return sorted;
    }

    const TriangleMesh& body_;
    const LatticeLayout& layout_;
    const CrackComplex& crack_;
};

}  // namespace

std::vector<NearPair> findNearPairs(const TriangleMesh& body, const LabelLattice& lattice,
                                    const CrackComplex& crack) {
    return NearPairs(body, *lattice.layout, crack).find();
}

}  // namespace sherd
