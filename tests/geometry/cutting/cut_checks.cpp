#include "geometry/cutting/cut_checks.h"

#include <cmath>
#include <map>
#include <vector>

#include "geometry/mass_properties.h"
#include "support/piece_checks.h"

namespace sherd::fragment_support {

namespace {

std::string faultOfNeighbours(const FragmentSurfaces& cut) {
    std::map<std::array<Corner, 3>, int> owner;
    for (std::size_t p = 0; p < cut.pieces.size(); ++p)
        for (std::size_t t = 0; t < cut.pieces[p].parents.size(); ++t)
            if (cut.pieces[p].parents[t] < 0)
                owner[cornersOf(cut.pieces[p].mesh, t, false)] = static_cast<int>(p);
    for (const FragmentSurface& piece : cut.pieces)
        for (std::size_t t = 0; t < piece.parents.size(); ++t)
            if (piece.parents[t] < 0 && owner.at(cornersOf(piece.mesh, t, true)) != piece.across[t])
                return "a crack triangle names a wrong neighbour";
    return "";
}

}  // namespace

std::string faultOfCut(const TriangleMesh& body, const FragmentSurfaces& cut) {
    double sum = 0;
    for (std::size_t p = 0; p < cut.pieces.size(); ++p) {
        sum += solidMoments(cut.pieces[p].mesh).volume;
        const std::string fault = faultOf(cut.pieces[p].mesh);
        if (!fault.empty()) return "piece " + std::to_string(p) + ": " + fault;
    }
    const double volume = solidMoments(body).volume;
    if (!(std::abs(sum - volume) <= 1e-3 * volume)) return "the volumes do not add up";
    std::vector<TriangleMesh> pieces;
    for (const FragmentSurface& piece : cut.pieces) {
        pieces.push_back(piece.mesh);
        std::vector<SurfaceKind>& kinds =
            pieces.back().kinds;  // of this cut: the body may have had cracks before
        kinds.assign(piece.parents.size(), SurfaceKind::original);
        for (std::size_t t = 0; t < kinds.size(); ++t)
            if (piece.parents[t] < 0) kinds[t] = SurfaceKind::crack;
    }
    const std::string fault = faultOfCracks(pieces);
    return fault.empty() ? faultOfNeighbours(cut) : fault;
}

}  // namespace sherd::fragment_support
