#pragma once

#include <sherd/push.h>
#include <sherd/result.h>

#include <memory>
#include <vector>

#include "bullet/strikes/contact_collector.h"

namespace sherd {

/// Says which figure of a push is out of range, or that there is none.
Status checkPushes(const std::vector<Push>& pushes);

/// Says which push would make the body, or what it has of mass where it is held, faster than light: the
/// numbers of Bullet's solver would overflow.
Status checkSpeeds(const Breakable& breakable, const std::vector<Push>& pushes);

/// Says which push acts beside the body: further from its surface than half its radius.
Status checkPlaces(const Breakable& breakable, const std::vector<Push>& pushes);

/// Pushes as contacts of the body: each stops a striker of the speed v that carries J = m v. Where v is not
/// known it is that which all pushes give to the place, or this one alone if that is more: with one, m is the
/// body's own effective mass at the point, and 1/2 m v^2 what J gives to the body. A push given in parts
/// brings what it brings as one.
StruckBreakable asContacts(Breakable& breakable, const std::vector<Push>& pushes);

/// Pushes a body, if it moves.
void push(btRigidBody& body, const std::vector<Push>& pushes);

/// The same pushes, none slower than what they give to the places that they hit: of a held body, as a mass.
std::vector<Push> withSpeeds(const Breakable& breakable, std::vector<Push> pushes);

/// Pushes the pieces of a body that was held: those that came loose take the impulse as one rigid body, up to
/// the speed of the push. The rest, and what falls on a piece that is still held, goes to what holds it.
void pushLoose(const std::vector<std::unique_ptr<Breakable>>& pieces, const std::vector<Push>& pushes);

/// The same pushes in another frame.
std::vector<Push> moved(std::vector<Push> pushes, const btTransform& transform);

/// How far the surface of a body is from a point of the world, m.
double distanceTo(const Breakable& breakable, const btVector3& point);

}  // namespace sherd
