#include "geometry/cutting/surface_fitting.h"

namespace sherd {

namespace {

class SurfaceFitting {
  public:
    SurfaceFitting(const TriangleTree& surface, const LabelLattice& lattice, int outside)
        : surface_(surface), lattice_(lattice), outside_(outside) {}

    std::vector<int> fit(CrackComplex& complex) const {
        std::vector<int> triangle_at;  // #points; -1 elsewhere
        for (CrackPoint& point : complex.origins)
            triangle_at.push_back(isOnSurface(point) ? fitToEdge(point) : -1);
        for (CrackPoint& point : complex.origins)
            if (!point.isOnEdge() && !point.isInTetrahedron()) leanOnSurface(complex, point);
        placePoints(complex, lattice_);
        return triangle_at;
    }

  private:
    bool isOutside(int node) const { return lattice_.labels[node] == outside_; }

    bool isOnSurface(const CrackPoint& point) const {
        return point.isOnEdge() && isOutside(point.nodes[0]) != isOutside(point.nodes[1]);
    }

    int fitToEdge(CrackPoint& point) const {
        const bool starts_inside = isOutside(point.nodes[1]);
        const Vec3 &inside = lattice_.nodes[point.nodes[starts_inside ? 0 : 1]],
                   &outside = lattice_.nodes[point.nodes[starts_inside ? 1 : 0]];
        point.fixed = true;
        const auto hit = surface_.firstHit(inside, outside);
        if (!hit || !hit->place)  // the edge runs along a triangle: the point stays in its middle
            return surface_.nearest(outside).triangle;
        const double t = (*hit->place - inside).norm() / (outside - inside).norm();
        point.t = clampToEdge(starts_inside ? t : 1 - t, lattice_.smallest_edge_place);
        return hit->triangle;
    }

    // A point where a crack meets the surface lies between two points on the surface and one on the crack
    // inside: moves it nearly between the first two.
    void leanOnSurface(const CrackComplex& complex, CrackPoint& point) const {
        std::array<double, 4> weights = {0.1, 0.1, 0.1, 0};
        int count = 0;
        for (int i = 0; i < 3; ++i)
            if (isOnSurface(complex.origins[point.between[i]])) weights[i] = 0.45, ++count;
        if (count != 2) return;
        point.weights = weights;
        point.fixed = true;
    }

    const TriangleTree& surface_;
    const LabelLattice& lattice_;
    int outside_;
};

}  // namespace

std::vector<int> fitToSurface(const TriangleTree& surface, const LabelLattice& lattice, int outside,
                              CrackComplex& complex) {
    return SurfaceFitting(surface, lattice, outside).fit(complex);
}

}  // namespace sherd
