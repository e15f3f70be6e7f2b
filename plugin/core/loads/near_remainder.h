#pragma once

#include <vector>

#include "core/loads/surface_tree.h"
#include "core/stress/near_field.h"

namespace sherd {

/// A small piece of the surface, and what the near field leaves there.
struct RemainderPiece {
    Vec3 centre = Vec3::Zero();  ///< m
    Vec3 area = Vec3::Zero();    ///< m^2, outward
    double size_m2 = 0;          ///< of that; of pieces that were merged the sum of their own
    double share = 1;            ///< of what is left there that belongs to the piece
    Vec3 force = Vec3::Zero();   ///< its share of (t - sigma n) A, N; t: the tractions of the discs
};

/// What the near field leaves close to one of its discs (NearField::closeShare).
std::vector<RemainderPiece> closeRemainder(const SurfaceTree& surface, const NearField& near,
                                           std::size_t disc);

/// What it leaves on a wall's other face, that is not close. `opposite`: see oppositeOf.
std::vector<RemainderPiece> oppositeRemainder(const SurfaceTree& surface, const NearField& near,
                                              const ContactDisc& opposite);

/// As far around as what a disc leaves on the other face of a wall acts: a disc on the plane there, as large
/// as the wall is thick, with the same force. `there`: on that face.
ContactDisc oppositeOf(const ContactDisc& disc, const Vec3& there);

/// The grid on which a remainder is solved.
struct RemainderGrid {
    double spacing_m = 0;
    double poisson_ratio = 0;
};

/// What the grid misses at places, Pa, of the stress that a remainder makes right where it acts, about a
/// disc. A piece presses on a disc of its own size on its own plane, and the grid sees a disc that is as wide
/// as a cell: the difference of these two fields balances itself, and ends within a few cells.
std::vector<SymmetricTensor> unresolvedAt(const std::vector<SurfacePlace>& places,
                                          const std::vector<RemainderPiece>& pieces, const ContactDisc& disc,
                                          const RemainderGrid& grid);

}  // namespace sherd
