#pragma once

#include <memory>

class btDispatcher;

namespace sherd {

/// Finds the contacts of fragments (PieceHull) with whatever is convex and moves slowly against them, where
/// one of the two is small, in units of its size. Bullet's GJK and EPA have tolerances in metres, square
/// metres and cubic metres that suit bodies of a metre: of slabs of 5 cm that touch or overlap they miss
/// every tenth, and of those of 5 mm they know no depth. Pieces that lie on each other then fall through, are
/// found too late, and are pushed out again, on and on. In units of their own size they are found by the same
/// code, as those of a metre are.
///
/// For as long as this object lives, the dispatcher's table of algorithms (registerCollisionCreateFunc) has
/// entries of Sherd's where a convex hull is one of two convex shapes. All other pairs go to what stood
/// there before. A dispatcher of another kind than btCollisionDispatcher is left as it is.
class PieceContacts {
  public:
    /// The dispatcher has to outlive this object.
    explicit PieceContacts(btDispatcher& dispatcher);

  private:
    class Table;
    class Entry;
    std::shared_ptr<Table> table_;  // of the dispatcher, which several worlds may have
};

}  // namespace sherd
