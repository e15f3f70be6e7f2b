#include "geometry/cutting/plane_cuts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "core/numerics/parallel_chunks.h"
#include "core/numerics/union_find.h"
#include "geometry/cutting/cap_triangulation.h"
#include "geometry/cutting/plane_cut.h"

namespace sherd {

namespace {

using FaceSide = CutComplex::FaceSide;

/// Divides a body as a crack tree says, part after part.
class TreeCutting {
  public:
    TreeCutting(const CuttableSurface& surface, const Discretisation& solid, const FragmentLabels& labels)
        : surface_(surface),
          solid_(solid),
          tree_(*labels.cracks),
          particles_(static_cast<std::size_t>(tree_.size())),
          complex_(surface.mesh()),
          cutter_(surface, solid.spacing, complex_) {
        for (std::size_t i = 0; i < labels.part.size(); ++i)
            for (int part = labels.part[i]; part >= 0; part = tree_.parentOf(part))
                particles_[part].push_back(static_cast<int>(i));
    }

    /// The faces between the leaves of the tree; none if a cut cannot be closed.
    std::optional<CutComplex> run() {
        PartBoundary whole;
        for (int block = 0; block < surface_.blockCount(); ++block) whole.blocks.push_back(block);
        const std::vector<int> roots = tree_.piecesOf(-1);
        if (roots.size() == 1)
            give(roots.front(), std::move(whole));
        else
            giveToPieces(roots, whole);
        while (!waiting_.empty())
            if (!divide(std::exchange(waiting_, {}))) return std::nullopt;
        complex_.refineAll();  // at what was split from the other side of a crack later
        return std::move(complex_);
    }

  private:
    struct Part {
        int number;
        PartBoundary boundary;
    };

    /// Notes the part to be divided, or if it is a leaf, what bounds it.
    void give(int part, PartBoundary boundary) {
        if (tree_.planeThrough(part) || !tree_.piecesOf(part).empty()) {
            waiting_.push_back({part, std::move(boundary)});
            return;
        }
        for (const FaceSide& at : facesOf(boundary)) complex_.setPart(at, part);
    }

    std::vector<FaceSide> facesOf(const PartBoundary& boundary) {
        std::vector<FaceSide> faces;
        for (const int block : boundary.blocks)
            surface_.forEachIn(block, [&](int triangle) { faces.push_back({triangle, 0}); });
        for (const FaceSide& at : boundary.faces) complex_.appendWhole(at, faces);
        return faces;
    }

    /// Parts that do not contain each other. Closing their cuts takes most of the time: that is done side by
    /// side. False if one cannot be closed.
    bool divide(const std::vector<Part>& parts) {
        std::vector<int> numbers;
        std::vector<PlaneCut> cuts;
        for (const Part& part : parts) {
            const CrackPlane* plane = tree_.planeThrough(part.number);
            if (plane) {
                numbers.push_back(part.number);
                cuts.push_back(cutter_.cut(part.boundary, *plane));
            } else {
                giveToPieces(tree_.piecesOf(part.number), part.boundary);
            }
        }
        std::vector<std::optional<std::vector<Triangle>>> caps(cuts.size());
        forEachChunk(static_cast<int>(cuts.size()), [&](int c) {
            caps[c] =
                triangulateCap(complex_.points(), tree_.planeThrough(numbers[c])->normal, cuts[c].outlines);
        });
        for (std::size_t c = 0; c < cuts.size(); ++c) {
            if (!caps[c]) return false;
            for (const Triangle& corners : *caps[c]) {
                const int face = complex_.addCrackFace(corners);
                for (const int side : {0, 1}) cuts[c].sides[side].faces.push_back({face, side});
            }
            for (const int side : {0, 1})
                give(tree_.below(numbers[c]) + side, std::move(cuts[c].sides[side]));
        }
        return true;
    }

    /// Faces that touch go to one piece, see `pieceAt`.
    void giveToPieces(const std::vector<int>& pieces, const PartBoundary& boundary) {
        const std::vector<FaceSide> faces = facesOf(boundary);
        UnionFind touching(complex_.points().size());
        for (const FaceSide& at : faces) {
            const auto& [a, b, c] = complex_.faces()[at.face].corners;
            touching.unite(a, b);
            touching.unite(b, c);
        }
        std::map<int, std::vector<FaceSide>> components;
        for (const FaceSide& at : faces)
            components[touching.root(complex_.faces()[at.face].corners[0])].push_back(at);
        std::map<int, PartBoundary> of_piece;
        for (const auto& [root, component] : components) {
            std::vector<FaceSide>& own = of_piece[pieceAt(component, pieces)].faces;
            own.insert(own.end(), component.begin(), component.end());
        }
        for (auto& [piece, own] : of_piece) give(piece, std::move(own));
    }

    /// The piece whose particles are nearest to some of the corners. Where the particles of several pieces
    /// are, since the solid is joined at a neck that has none, it is the piece with most particles.
    int pieceAt(const std::vector<FaceSide>& component, const std::vector<int>& pieces) const {
        constexpr std::size_t most_asked = 24;  // enough to see a piece that has a quarter of the surface
        constexpr std::size_t least_share = 4;  // one in so many; fewer are near by chance
        const std::size_t asked = std::min(most_asked, component.size());
        std::map<int, std::size_t> votes;
        for (std::size_t k = 0; k < asked; ++k) {
            const int face = component[k * component.size() / asked].face;
            ++votes[nearestPiece(complex_.points()[complex_.faces()[face].corners[0]], pieces)];
        }
        int best = -1;
        for (const auto& [piece, count] : votes)
            if (least_share * count >= asked &&
                (best < 0 || particles_[piece].size() > particles_[best].size()))
                best = piece;
        return best >= 0 ? best : votes.begin()->first;
    }

    int nearestPiece(const Vec3& x, const std::vector<int>& pieces) const {
        double nearest = std::numeric_limits<double>::infinity();
        int piece = pieces.front();
        for (const int candidate : pieces)
            for (const int i : particles_[candidate]) {
                const double distance = (solid_.particles[i].position - x).squaredNorm();
                if (distance < nearest) nearest = distance, piece = candidate;
            }
        return piece;
    }

    const CuttableSurface& surface_;
    const Discretisation& solid_;
    const CrackTree& tree_;
    std::vector<std::vector<int>> particles_;  // of each part
    CutComplex complex_;
    PlaneCutter cutter_;
    std::vector<Part> waiting_;
};

std::vector<int> labelsOfParts(const FragmentLabels& labels) {
    std::vector<int> of_part(static_cast<std::size_t>(labels.cracks->size()), -1);
    for (std::size_t i = 0; i < labels.part.size(); ++i) of_part[labels.part[i]] = labels.of_particle[i];
    return of_part;
}

/// What the triangles of the body have become, in their order.
void collectBody(const CutComplex& complex, int body_count, const std::vector<int>& label_of, CutFaces& cut) {
    for (std::vector<int>* all : {&cut.body_parent, &cut.body_label}) all->reserve(complex.faces().size());
    cut.body.reserve(complex.faces().size());
    std::vector<int> front;
    for (int triangle = 0; triangle < body_count; ++triangle) {
        front.assign(1, triangle);
        while (!front.empty()) {
            const CutComplex::Face& face = complex.faces()[front.back()];
            front.pop_back();
            for (int k = 0; k < face.child_count; ++k) front.push_back(face.first_child + k);
            if (face.first_child >= 0) continue;
            cut.body.push_back(face.corners);
            cut.body_parent.push_back(triangle);
            cut.body_label.push_back(label_of[face.parts[0]]);
        }
    }
}

void collectCracks(const CutComplex& complex, const std::vector<int>& label_of, CutFaces& cut) {
    for (const CutComplex::Face& face : complex.faces()) {
        if (face.parent >= 0 || face.first_child >= 0) continue;
        const CrackComplex::Sides sides{label_of[face.parts[0]], label_of[face.parts[1]]};
        if (sides.below == sides.above) continue;  // one piece
        cut.crack.push_back(face.corners);
        cut.crack_sides.push_back(sides);
    }
}

/// Numbers the sets of the body's faces that whole edges of the body connect.
void joinAlongEdges(const CuttableSurface& surface, CutFaces& cut) {
    const EdgeTable& edges = surface.edges();
    UnionFind sets(cut.body.size());
    std::vector<int> first_at(edges.edges.size(), -1);
    const auto join = [&](std::size_t f, int parent, int side) {
        int& first = first_at[edges.of_triangle[parent][side]];
        if (first < 0)
            first = static_cast<int>(f);
        else
            sets.unite(first, static_cast<int>(f));
    };
    for (std::size_t f = 0; f < cut.body.size(); ++f) {
        const int parent = cut.body_parent[f];
        const Triangle &own = cut.body[f], &whole = surface.mesh().triangles[parent];
        if (own == whole) {
            for (int side = 0; side < 3; ++side) join(f, parent, side);
            continue;
        }
        for (int i = 0; i < 3; ++i)
            for (int side = 0; side < 3; ++side)
                if (own[i] == whole[side] && own[(i + 1) % 3] == whole[(side + 1) % 3]) join(f, parent, side);
    }
    cut.body_set = sets.roots();
    cut.body_set_count = static_cast<int>(cut.body.size());
}

}  // namespace

bool arePlanesEnough(const FragmentLabels& labels) {
    return labels.cracks && !labels.cracks->rootsTouch();
}

std::optional<CutFaces> cutByPlanes(const CuttableSurface& surface, const Discretisation& solid,
                                    const FragmentLabels& labels) {
    std::optional<CutComplex> complex = TreeCutting(surface, solid, labels).run();
    if (!complex) return std::nullopt;
    const std::vector<int> label_of = labelsOfParts(labels);
    CutFaces cut;
    collectBody(*complex, static_cast<int>(surface.mesh().triangles.size()), label_of, cut);
    collectCracks(*complex, label_of, cut);
    joinAlongEdges(surface, cut);
    cut.body_point_count = complex->bodyPointCount();
    cut.points = complex->takePoints();
    return cut;
}

}  // namespace sherd
