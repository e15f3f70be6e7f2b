#include "core/mlpg/splines/spacing_choice.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/linear_algebra/cholesky_solver.h"
#include "core/mlpg/splines/stiffness_pattern.h"
#include "core/sampling/sample_solid.h"

namespace sherd {
namespace {

constexpr int attempts = 6;
constexpr double supernodal_surplus = 1.25;  // dense blocks store zeros too; 1.22 to 1.37 was measured
constexpr double good_use = 0.75;    // of the entries that are allowed; closer is not worth another attempt
constexpr double aim = 0.87;         // the middle of what is good
constexpr double entries_power = 3;  // they grow about as h^-3, from h^-2.5 of sheets to h^-4 of blocks

Result<double> factorEntriesAt(const TriangleMesh& surface, double spacing, int degree,
                               int cells_per_spacing) {
    const Result<CellParts> parts = sampleParts(surface, spacing, cells_per_spacing, 0, MomentRule::quick);
    if (!parts) return Error{parts.error()};
    const SplineSpace space(parts.value(), degree);
    const Result<double> entries =
        factorEntriesOf(emptyMatrixOf(StiffnessPattern(space)), space.highest_cells);
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

/// Looks for spacings, and remembers what it saw.
template <class EntriesAt>
class Search {
  public:
    explicit Search(const EntriesAt& entries_at) : entries_at_(entries_at) {}

    /// Entries of the factor at a spacing. A grid that is too large to be laid has far too many.
    double look(double spacing) {
        const auto found = entries_.find(spacing);
        if (found != entries_.end()) return found->second;
        const Result<double> entries = entries_at_(spacing);
        return entries_[spacing] = entries ? entries.value() : 1e15;
    }

    /// Whether some spacing from `spacing` up was seen to have more entries.
    bool isTooFine(double spacing, double largest) const {
        return std::any_of(entries_.lower_bound(spacing), entries_.end(),
                           [&](const auto& seen) { return seen.second > largest; });
    }

    /// The finest spacing from `finest` up with no more than `largest` entries, or one with at least
    /// `good_use` of them.
    double finestWithin(double finest, double largest, double guess) {
        double spacing = std::max(finest, guess);
        double too_fine = 0;  // the coarsest spacing known to need too much
        double good = 0;      // the finest one known to do
        const auto judge = [&](double seen, double entries) {
            if (entries > largest)
                too_fine = std::max(too_fine, seen);
            else
                good = std::max(finest, good > 0 ? std::min(good, seen) : seen);
            const double next = seen * std::pow(entries / (aim * largest), 1 / entries_power);
            spacing = good > 0 ? std::clamp(next, std::max(finest, 1.001 * too_fine),
                                            std::max(1.001 * too_fine, 0.999 * good))
                               : std::max(next, 1.03 * too_fine);
            return good > 0 && (good <= finest || (entries <= largest && entries > good_use * largest) ||
                                too_fine > 0.97 * good);
        };
        for (const auto& [seen, entries] : entries_)
            if (judge(seen, entries)) return good;
        for (int attempt = 0; attempt < attempts; ++attempt) {
            const double seen = spacing;
            if (judge(seen, look(seen))) return good;
        }
        return good > 0 ? good : spacing;
    }

  private:
    const EntriesAt& entries_at_;
    std::map<double, double> entries_;  // per spacing
};

}  // namespace

Result<double> chooseSpacing(const TriangleMesh& surface, const SpacingWish& wish, int cells_per_spacing) {
    const auto entries_at = [&](double spacing) {
        return factorEntriesAt(surface, spacing, wish.spline_degree, cells_per_spacing);
    };
    constexpr double near_wall = 1.15;  // as far as the guess may be wrong
    const double guess = firstGuess(surface, wish.largest_factor_entries);
    const double thin = std::max(wish.wall_m, wish.finest_m);
    Search search(entries_at);
    // A spacing of one wall decides which of the limits holds, and is mostly the answer under the second.
    if (guess < near_wall * thin && thin < near_wall * guess) (void)search.look(thin);
    if (!search.isTooFine(wish.wall_m, wish.largest_factor_entries)) {
        const double spacing = search.finestWithin(wish.finest_m, wish.largest_factor_entries, guess);
        if (spacing <= wish.wall_m) return spacing;
    }
    return search.finestWithin(thin, wish.largest_if_thin, guess);
}

}  // namespace sherd
