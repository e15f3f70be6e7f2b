#pragma once

#include <vector>

#include "bullet/bodies/breakable.h"

class btDiscreteDynamicsWorld;

namespace sherd {

/// What belongs to one blow (FractureSettings::same_blow_s). The pieces of a body still fly apart, what
/// struck the whole goes on pushing them, and young fragments of several bodies fly in one cloud: contacts
/// between these are no new blows. What else strikes a piece is one. So it does not matter whether a body
/// broke a step earlier, by a splinter that flew ahead of the striker: the striker breaks its pieces as it
/// would have broken the whole.

/// The tokens of all that touches a body now, and its own.
std::vector<BodyToken> partOfTheBlowOn(btDiscreteDynamicsWorld& world, const btRigidBody& whole);

/// Notes what a new piece of `whole` is part of a blow with, beside what its parent still is.
void noteBlow(const std::vector<BodyToken>& bodies, const Breakable& whole, double time_s, Breakable& piece);

/// Whether a contact of `piece` with `other` belongs to the blow that made the piece. `breakable`: `other`,
/// nullptr if it is not breakable.
bool isOfTheSameBlow(const Breakable& piece, const btCollisionObject& other, const Breakable* breakable,
                     double time_s);

}  // namespace sherd
