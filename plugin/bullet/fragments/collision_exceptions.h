#pragma once

#include <memory>
#include <vector>

class btDiscreteDynamicsWorld;

namespace sherd {

struct Breakable;

/// Takes over to the fragments which objects the app does not let `parent` collide with
/// (setIgnoreCollisionCheck), whichever of the two it told so. Exceptions that only a joint makes end with
/// the joint.
void inheritCollisionExceptions(btDiscreteDynamicsWorld& world, const Breakable& parent,
                                const std::vector<std::unique_ptr<Breakable>>& fragments);

}  // namespace sherd
