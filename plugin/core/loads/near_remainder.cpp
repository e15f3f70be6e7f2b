#include "core/loads/near_remainder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/loads/load_patch.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

constexpr double piece_length = 0.25;  // of a radius

RemainderPiece shareOf(const PieceNearby& piece, double share) {
    return {piece.centre, share * piece.area, share * piece.area.norm(), Vec3::Zero()};
}

/// The pieces of the surface that belong to those about a disc.
std::vector<RemainderPiece> piecesAbout(const SurfaceTree& surface, const NearField& near, std::size_t disc) {
    const ContactDisc& about = near.discs()[disc];
    std::vector<RemainderPiece> pieces;
    for (const PieceNearby& piece : surfaceAround(surface, about.centre, close_reach * about.radius,
                                                  about.radius, piece_length * about.radius)) {
        const double share = near.closeShare(piece.centre, disc);
        if (share * piece.area.squaredNorm() > 0) pieces.push_back(shareOf(piece, share));
    }
    return pieces;
}

/// What a field makes of the pieces as the surface of a solid, N.
RowsOf3 forcesOn(const std::vector<RemainderPiece>& pieces, const NearField& near) {
    const auto count = static_cast<Eigen::Index>(pieces.size());
    SurfacePieces rows{RowsOf3(count, 3), RowsOf3(count, 3)};
    for (Eigen::Index i = 0; i < count; ++i) {
        rows.places.row(i) = pieces[i].centre;
        rows.areas.row(i) = pieces[i].size_m2 * pieces[i].area.normalized();
    }
    return near.forcesOn(rows);
}

/// Takes the near field's forces from those on the pieces.
void clear(const NearField& near, std::vector<RemainderPiece>& pieces) {
    const RowsOf3 of_stress = forcesOn(pieces, near);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        pieces[i].force -= of_stress.row(static_cast<Eigen::Index>(i)).transpose();
}

/// Pieces that face alike in one cube, as one: a mesh may be far finer than is needed. The cubes are larger
/// further away from the disc; `length`: of their edges next to it, in radii.
std::vector<RemainderPiece> merged(const std::vector<RemainderPiece>& pieces, const ContactDisc& disc,
                                   double length) {
    constexpr double facing = 2;  // steps of a normal's component
    std::map<std::array<long, 7>, RemainderPiece> cubes;
    for (const RemainderPiece& piece : pieces) {
        const Vec3 offset = (piece.centre - disc.centre) / disc.radius;
        const int level = std::max(0, std::ilogb(offset.squaredNorm()));
        std::array<long, 7> cube{level};
        for (int d = 0; d < 3; ++d) {
            cube[1 + d] = std::lround(std::ldexp(offset[d] / length, -level));
            cube[4 + d] = std::lround(facing * piece.area[d] / piece.size_m2);
        }
        RemainderPiece& sum = cubes[cube];
        sum.centre += piece.size_m2 * piece.centre;
        sum.area += piece.area;
        sum.size_m2 += piece.size_m2;
        sum.force += piece.force;
    }
    std::vector<RemainderPiece> found;
    for (auto& [cube, sum] : cubes) {
        sum.centre /= sum.size_m2;
        if (sum.area.norm() > 0) found.push_back(sum);
    }
    return found;
}

/// A piece's force on a disc of that radius on the piece's plane.
ContactDisc pressedOn(const RemainderPiece& piece, double radius) {
    const double whole = 0.4 * pi * radius * radius;  // of the profile
    return {piece.centre, -piece.area.normalized(), radius, piece.force / whole, false};
}

/// What discs, one on each piece, press on the pieces that they cover.
Vec3 pressureOn(const RemainderPiece& piece, const std::vector<ContactDisc>& discs) {
    constexpr double facing = 0.5;  // cosine
    const Vec3 outward = piece.area.normalized();
    Vec3 sum = Vec3::Zero();
    for (const ContactDisc& disc : discs)
        if (outward.dot(disc.inward) < -facing) sum += disc.tractionAt(piece.centre);
    return piece.size_m2 * sum;
}

NearField discsOn(const std::vector<RemainderPiece>& pieces, const std::vector<double>& radii,
                  double poisson_ratio) {
    std::vector<ContactDisc> discs;
    for (std::size_t i = 0; i < pieces.size(); ++i) discs.push_back(pressedOn(pieces[i], radii[i]));
    return NearField(discs, poisson_ratio);
}

/// Makes the forces such that discs of those radii together leave nothing of them. On a plane they are right
/// at once; else each disc also leaves something on the others, whose planes are others. Clearing that once
/// leaves half of the error on a lip as round as its contact is wide, so what changes is taken twice. Where
/// more would change than there is, as between faces that lie opposite each other, nothing is.
void balance(std::vector<RemainderPiece>& pieces, const std::vector<double>& radii, double poisson_ratio) {
    const NearField first = discsOn(pieces, radii, poisson_ratio);
    const RowsOf3 of_stress = forcesOn(pieces, first);
    std::vector<Vec3> changes;
    double change = 0, whole = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        changes.push_back(pressureOn(pieces[i], first.discs()) -
                          of_stress.row(static_cast<Eigen::Index>(i)).transpose());
        change += changes[i].norm();
        whole += pieces[i].force.norm();
    }
    if (change > whole) return;
    for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].force += 2 * changes[i];
}

}  // namespace

std::vector<RemainderPiece> closeRemainder(const SurfaceTree& surface, const NearField& near,
                                           std::size_t disc) {
    std::vector<RemainderPiece> pieces = piecesAbout(surface, near, disc);
    for (RemainderPiece& piece : pieces)
        piece.force = piece.size_m2 * near.tractionAt(piece.centre, piece.area / piece.size_m2);
    clear(near, pieces);
    return pieces;
}

std::vector<RemainderPiece> oppositeRemainder(const SurfaceTree& surface, const NearField& near,
                                              const ContactDisc& opposite) {
    constexpr double reach = 2.5;  // radii
    std::vector<RemainderPiece> pieces;
    for (const PieceNearby& piece : surfaceAround(surface, opposite.centre, reach * opposite.radius,
                                                  opposite.radius, piece_length * opposite.radius)) {
        const double share = 1 - near.closeShare(piece.centre);
        const bool is_on_that_face = piece.area.dot(opposite.inward) < 0;
        if (is_on_that_face && share > 0) pieces.push_back(shareOf(piece, share));
    }
    clear(near, pieces);
    return pieces;
}

ContactDisc oppositeOf(const ContactDisc& disc, const Vec3& there) {
    const double depth = (there - disc.centre).norm(), smaller = disc.radius / depth;
    return {there, -disc.inward, depth, -smaller * smaller * disc.traction_pa, false};
}

std::vector<SymmetricTensor> unresolvedAt(const std::vector<SurfacePlace>& places,
                                          const std::vector<RemainderPiece>& pieces, const ContactDisc& disc,
                                          const RemainderGrid& grid) {
    constexpr double finely = 0.3, coarsely = 1;  // merged, in radii
    constexpr double overlap = 2;                 // of discs, so that side by side they press evenly
    constexpr double faint = 0.015;               // of the disc's own traction: leaves nothing
    // How wide a grid of quadratic splines spreads a force, in spacings. With 1 to 1.6 the largest stress of
    // blows on a cup is within 11 to 12 % of finite elements in nine of ten.
    constexpr double blur = 1.3;
    constexpr double ends = 2;  // widths beyond the pieces
    const double wide = blur * grid.spacing_m, reach = close_reach * disc.radius + ends * wide;
    std::vector<RemainderPiece> missed;
    std::vector<double> radii;
    for (const RemainderPiece& piece : merged(pieces, disc, finely)) {
        const double radius = overlap * std::sqrt(piece.size_m2 / pi);
        if (radius >= wide || piece.force.norm() < faint * disc.traction_pa.norm() * piece.size_m2) continue;
        missed.push_back(piece);
        radii.push_back(radius);
    }
    std::vector<SymmetricTensor> unresolved(places.size(), SymmetricTensor::Zero());
    if (missed.empty()) return unresolved;
    balance(missed, radii, grid.poisson_ratio);
    const NearField own = discsOn(missed, radii, grid.poisson_ratio);
    std::vector<ContactDisc> wide_discs;
    for (const RemainderPiece& piece : merged(missed, disc, coarsely))
        wide_discs.push_back(pressedOn(piece, wide));
    const NearField seen(wide_discs, grid.poisson_ratio);
    std::vector<std::size_t> near_by;
    for (std::size_t i = 0; i < places.size(); ++i)
        if ((places[i].position - disc.centre).norm() < reach) near_by.push_back(i);
    constexpr std::size_t lanes = PlaceLanes::count;
    for (std::size_t first = 0; first < near_by.size(); first += lanes) {
        const std::size_t count = std::min(lanes, near_by.size() - first);
        PlaceLanes at;
        for (std::size_t l = 0; l < lanes; ++l)
            for (int d = 0; d < 3; ++d)
                at.x[d][l] = places[near_by[first + std::min(l, count - 1)]].position[d];
        StressLanes more = {}, less = {};
        own.addStressAt(at, more);
        seen.addStressAt(at, less);
        for (std::size_t l = 0; l < count; ++l)
            unresolved[near_by[first + l]] = more.at(static_cast<int>(l)) - less.at(static_cast<int>(l));
    }
    return unresolved;
}

}  // namespace sherd
