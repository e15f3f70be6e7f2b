#pragma once

#include <btBulletDynamicsCommon.h>

#include "render/marks.h"

namespace demo {

/// The edges of the collision shapes of all bodies that can move, or were held, as Bullet draws them.
void addShapeLines(render::Marks& marks, btDiscreteDynamicsWorld& world);

}  // namespace demo
