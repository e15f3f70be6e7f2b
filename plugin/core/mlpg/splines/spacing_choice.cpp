#include "core/mlpg/splines/spacing_choice.h"

#include <algorithm>
#include <cmath>

#include "core/linear_algebra/cholesky_solver.h"
#include "core/mlpg/splines/stiffness_pattern.h"
#include "core/sampling/cell_moments.h"

namespace sherd {
namespace {

constexpr int attempts = 6;
constexpr double supernodal_surplus = 1.25;  // dense blocks store zeros too; 1.1 to 1.25 was measured
constexpr double good_use = 0.6;  // of the entries that are allowed; closer is not worth another attempt
constexpr double entries_power =
    3;  // entries grow about as h^-3, from h^-2.5 of sheets to h^-4 of compact bodies

Result<double> factorEntriesAt(const TriangleMesh& surface, double spacing, int degree,
                               int cells_per_spacing) {
    const Result<SamplingGrid> grid = makeGrid(surface, spacing, cells_per_spacing);
    if (!grid) return Error{grid.error()};
    const CutSurface cut = cutSurface(surface, grid.value());
    const Result<SolidVoxels> solid = fillVoxels(grid.value(), cut);
    if (!solid) return Error{solid.error()};
    const CellParts parts = measureCellParts(surface, grid.value(), cut, solid.value(), 0);
    const StiffnessPattern pattern{SplineSpace(parts, degree)};
    const Result<double> entries = factorEntriesOf(blockMatrix(pattern), 3);
    if (!entries) return Error{entries.error()};
    return supernodal_surplus * entries.value();
}

/// Where the search starts: a grid cell for so many entries.
double firstGuess(const TriangleMesh& surface, double entries) {
    constexpr double entries_per_cell = 4000;
    double six_volumes = 0, area = 0;
    const Vec3 origin = surface.vertices[surface.triangles[0][0]];
    for (const auto& [a, b, c] : surface.triangles) {
        const Vec3 p = surface.vertices[a] - origin, q = surface.vertices[b] - origin,
                   r = surface.vertices[c] - origin;
        six_volumes += p.dot(q.cross(r));
        area += (q - p).cross(r - p).norm() / 2;
    }
    // Cells at spacing h: those inside, and half of those that the surface cuts.
    const double volume = std::abs(six_volumes) / 6, cells = entries / entries_per_cell;
    double spacing = std::cbrt(volume / cells);
    for (int i = 0; i < 20; ++i) spacing = std::cbrt((volume + 0.5 * area * spacing) / cells);
    return spacing;
}

/// The finest spacing from `finest` up with no more than `largest` entries, or one with at least `good_use`
/// of them.
template <class EntriesAt>
double finestWithin(const EntriesAt& entries_at, double finest, double largest, double guess) {
    double spacing = std::max(finest, guess);
    double too_fine = 0;  // the coarsest spacing known to need too much
    double good = 0;      // the finest one known to do
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const Result<double> entries = entries_at(spacing);
        // A grid that is too large to be laid is too fine as well.
        const double excess = entries ? entries.value() / largest : 1000;
        if (excess <= 1) {
            good = good > 0 ? std::min(good, spacing) : spacing;
            if (spacing <= finest || excess > good_use) return good;
        } else {
            too_fine = std::max(too_fine, spacing);
        }
        if (good > 0 && too_fine > 0.97 * good) return good;
        const double next = spacing * std::pow(excess / 0.85, 1 / entries_power);
        spacing = good > 0 ? std::clamp(next, std::max(finest, 1.001 * too_fine), 0.999 * good)
                           : std::max(next, 1.03 * too_fine);
    }
    return good > 0 ? good : spacing;
}

}  // namespace

Result<double> chooseSpacing(const TriangleMesh& surface, const SpacingWish& wish, int cells_per_spacing) {
    const auto entries_at = [&](double spacing) {
        return factorEntriesAt(surface, spacing, wish.spline_degree, cells_per_spacing);
    };
    const double guess = firstGuess(surface, wish.largest_factor_entries);
    const double spacing = finestWithin(entries_at, wish.finest_m, wish.largest_factor_entries, guess);
    if (spacing <= wish.wall_m) return spacing;
    return finestWithin(entries_at, std::max(wish.wall_m, wish.finest_m), wish.largest_if_thin, spacing);
}

}  // namespace sherd
