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
    return {piece.centre, piece.area, piece.area.norm(), share, Vec3::Zero()};
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

/// Takes the near field's forces from those on the pieces, and leaves each its share.
void clear(const NearField& near, std::vector<RemainderPiece>& pieces) {
    const RowsOf3 of_stress = forcesOn(pieces, near);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        pieces[i].force = pieces[i].share * (pieces[i].force - of_stress.row(Eigen::Index(i)).transpose());
}

/// A disc's own axes, as rows.
Mat3 axesOf(const ContactDisc& disc) {
    const Vec3 along = disc.inward.unitOrthogonal();
    Mat3 axes;
    axes << along.transpose(), disc.inward.cross(along).transpose(), disc.inward.transpose();
    return axes;
}

/// A piece on the disc that stands for it.
struct PressedDisc {
    RemainderPiece piece;
    double radius = 0;  ///< m
};

/// Pieces that face alike in one cube, as one: a mesh may be far finer than is needed, and rough. `length`:
/// of the cubes' edges, in radii of the disc; with `grow` they are as much larger as they are further away.
std::vector<PressedDisc> merged(const std::vector<RemainderPiece>& pieces, const ContactDisc& disc,
                                double length, bool grow) {
    constexpr double overlap = 2;  // of discs, so that side by side they press evenly
    constexpr double facing = 2;   // steps of a normal's component
    constexpr double least = 0.6;  // of a cube's edge: slivers are not to press on points
    const Mat3 axes = axesOf(disc);
    std::map<std::array<long, 7>, RemainderPiece> cubes;
    for (const RemainderPiece& piece : pieces) {
        const Vec3 offset = axes * (piece.centre - disc.centre) / disc.radius;
        const Vec3 outward = axes * piece.area / piece.size_m2;
        const int level = grow ? std::max(0, std::ilogb(offset.norm())) : 0;
        std::array<long, 7> cube{level};
        for (int d = 0; d < 3; ++d) {
            cube[1 + d] = std::lround(std::ldexp(offset[d] / length, -level));
            cube[4 + d] = std::lround(facing * outward[d]);
        }
        RemainderPiece& sum = cubes[cube];
        sum.centre += piece.size_m2 * piece.centre;
        sum.area += piece.area;
        sum.size_m2 += piece.size_m2;
        sum.force += piece.force;
    }
    std::vector<PressedDisc> found;
    for (auto& [cube, sum] : cubes) {
        sum.centre /= sum.size_m2;
        const double edge = std::ldexp(length * disc.radius, static_cast<int>(cube[0]));
        const double radius = std::max(overlap * std::sqrt(sum.size_m2 / pi), least * edge);
        if (sum.area.norm() > 0) found.push_back({sum, radius});
    }
    return found;
}

/// A piece's force on a disc of that radius on the piece's plane.
ContactDisc pressedOn(const RemainderPiece& piece, double radius) {
    const double whole = 0.4 * pi * radius * radius;  // of the profile
    return {piece.centre, -piece.area.normalized(), radius, piece.force / whole, false};
}

NearField discsOn(const std::vector<PressedDisc>& pressed, double poisson_ratio) {
    std::vector<ContactDisc> discs;
    for (const PressedDisc& one : pressed) discs.push_back(pressedOn(one.piece, one.radius));
    return NearField(discs, poisson_ratio);
}

/// What discs press on a piece that they cover.
Vec3 pressureOn(const RemainderPiece& piece, const std::vector<ContactDisc>& discs) {
    constexpr double facing = 0.5;                              // cosine
    constexpr double furthest = 1 + largest_sag * largest_sag;  // of what lies over a disc; saves time
    const Vec3 outward = piece.area.normalized();
    Vec3 sum = Vec3::Zero();
    for (const ContactDisc& disc : discs)
        if ((piece.centre - disc.centre).squaredNorm() < furthest * disc.radius * disc.radius &&
            outward.dot(disc.inward) < -facing &&
            std::abs((piece.centre - disc.centre).dot(disc.inward)) < largest_sag * disc.radius)
            sum += disc.tractionAt(piece.centre);
    return piece.size_m2 * sum;
}

/// Makes the forces such that the discs together leave nothing of them. On a plane they are right at once;
/// else each disc also leaves something on the others, whose planes are others. Clearing that once leaves
/// half of the error on a lip as round as its contact is wide, so what changes is taken twice; less where as
/// much would change as there is. What lies behind, maybe across air, takes no part.
void balance(std::vector<PressedDisc>& pressed, const ContactDisc& about, double poisson_ratio) {
    constexpr double deepest = 2;        // radii
    constexpr double facing_back = 0.2;  // cosine
    constexpr double all = 0.6, none = 1;
    std::vector<PressedDisc*> before;
    std::vector<PressedDisc> own;
    std::vector<RemainderPiece> pieces;
    for (PressedDisc& one : pressed) {
        const double depth = (one.piece.centre - about.centre).dot(about.inward);
        if (depth > deepest * about.radius || one.piece.area.normalized().dot(about.inward) > facing_back)
            continue;
        before.push_back(&one);
        own.push_back(one);
        pieces.push_back(one.piece);
    }
    const NearField near = discsOn(own, poisson_ratio);
    const RowsOf3 of_stress = forcesOn(pieces, near);
    std::vector<Vec3> changes;
    double change = 0, whole = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        changes.push_back(pressureOn(pieces[i], near.discs()) - of_stress.row(Eigen::Index(i)).transpose());
        change += changes[i].norm();
        whole += pieces[i].force.norm();
    }
    if (!(whole > 0)) return;
    const double factor = 2 * std::clamp((none - change / whole) / (none - all), 0.0, 1.0);
    for (std::size_t i = 0; i < pieces.size(); ++i) before[i]->piece.force += factor * changes[i];
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
    constexpr double finely = 2.0 / 7, coarsely = 1;  // merged, in radii; cubes end at the rim
    constexpr double blurred = 0.5;                   // of the wide discs, that the coarse pieces are at most
    constexpr double faint = 0.015;                   // of the disc's own traction: leaves nothing
    // How wide a grid of quadratic splines spreads a force, in spacings: with 1 to 2 the errors on a cup are
    // alike.
    constexpr double blur = 1.5;
    constexpr double ends = 2;  // widths beyond the pieces
    const double wide = blur * grid.spacing_m, reach = close_reach * disc.radius + ends * wide;
    std::vector<PressedDisc> missed;
    for (const PressedDisc& one : merged(pieces, disc, finely, true)) {
        const double least_n = faint * disc.traction_pa.norm() * one.piece.size_m2;
        if (one.radius >= wide || one.piece.force.norm() < least_n) continue;
        missed.push_back(one);
    }
    std::vector<SymmetricTensor> unresolved(places.size(), SymmetricTensor::Zero());
    if (missed.empty()) return unresolved;
    balance(missed, disc, grid.poisson_ratio);
    const NearField own = discsOn(missed, grid.poisson_ratio);
    std::vector<RemainderPiece> seen_pieces;
    for (const PressedDisc& one : missed) seen_pieces.push_back(one.piece);
    const double coarse = std::max(finely, std::min(coarsely, blurred * wide / disc.radius));
    std::vector<PressedDisc> seen_discs = merged(seen_pieces, disc, coarse, false);
    for (PressedDisc& one : seen_discs) one.radius = wide;
    const NearField seen = discsOn(seen_discs, grid.poisson_ratio);
    std::vector<std::size_t> near_by;
    for (std::size_t i = 0; i < places.size(); ++i)
        if ((places[i].position - disc.centre).norm() < reach) near_by.push_back(i);
    const auto add = [&](const NearField& field, double factor) {
        field.visitStress(
            static_cast<Eigen::Index>(near_by.size()),
            [&](Eigen::Index i) { return places[near_by[i]].position; },
            [&](Eigen::Index i, const SymmetricTensor& stress) {
                unresolved[near_by[i]] += factor * stress;
            });
    };
    add(own, 1);
    add(seen, -1);
    return unresolved;
}

}  // namespace sherd
