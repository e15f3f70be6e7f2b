#pragma once

#include <cstdint>

class btCollisionObject;

namespace sherd {

/// A number that tells one body from every other one of this process, dead or alive. It stands in the body's
/// extension pointer, which Bullet keeps for extensions, does not use itself, and sets to null in a new body.
/// So a body is itself wherever the app takes it, and a new body at the address of an old one is another.
using BodyToken = std::uintptr_t;
constexpr BodyToken no_token = 0;

/// The token of a body; no_token if it was never given one.
BodyToken tokenOf(const btCollisionObject& body);

/// Gives a body a token if it has none yet. no_token if something else already uses its extension pointer.
BodyToken giveToken(btCollisionObject& body);

}  // namespace sherd
