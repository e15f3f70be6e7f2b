#pragma once

#include <btBulletDynamicsCommon.h>
#include <sherd/fracture_world.h>

#include "render/marks.h"

namespace demo {

/// The edges of the collision shapes of all bodies that can move or break, as Bullet draws them.
void addShapeLines(render::Marks& marks, btDiscreteDynamicsWorld& world,
                   const sherd::FractureWorld& fracture);

}  // namespace demo
