#include "cut_checks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/mass_properties.h"
#include "piece_checks.h"

namespace sherd::fragment_support {

std::array<Corner, 3> cornersOf(const TriangleMesh& mesh, std::size_t t, bool reversed) {
    std::array<Corner, 3> corners;
    for (int i = 0; i < 3; ++i) {
        const Vec3& v = mesh.vertices[mesh.triangles[t][reversed ? 2 - i : i]];
        corners[i] = {v.x(), v.y(), v.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

namespace {

std::string faultOfCracks(const FragmentSurfaces& cut) {
    std::map<std::array<Corner, 3>, int> owner;
    for (std::size_t p = 0; p < cut.pieces.size(); ++p)
        for (std::size_t t = 0; t < cut.pieces[p].parents.size(); ++t)
            if (cut.pieces[p].parents[t] < 0 &&
                !owner.emplace(cornersOf(cut.pieces[p].mesh, t, false), static_cast<int>(p)).second)
                return "a crack triangle belongs to two pieces";
    for (std::size_t p = 0; p < cut.pieces.size(); ++p) {
        const FragmentSurface& piece = cut.pieces[p];
        for (std::size_t t = 0; t < piece.parents.size(); ++t) {
            if (piece.parents[t] >= 0) continue;
            const auto partner = owner.find(cornersOf(piece.mesh, t, true));
            if (partner == owner.end()) return "a crack triangle has no partner";
            if (partner->second == static_cast<int>(p)) return "a crack triangle has its partner in its own piece";
            if (partner->second != piece.across[t]) return "a crack triangle names a wrong neighbour";
        }
    }
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
    return faultOfCracks(cut);
}

}  // namespace sherd::fragment_support
