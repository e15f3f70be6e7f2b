#include "render/frame.h"

#include "render/projection.h"

namespace render {

Bounds Item::bounds() const {
    const Bounds& own = mesh->bounds();
    Bounds placed;
    for (int corner = 0; corner < 8; ++corner)
        placed.add(transformed(
            place, Vec3(corner & 1 ? own.hi.x() : own.lo.x(), corner & 2 ? own.hi.y() : own.lo.y(),
                        corner & 4 ? own.hi.z() : own.lo.z())));
    return placed;
}

void setLight(const Program& program, const Light& light) {
    program.set("to_sun", Vec3(-light.towards));
    program.set("sun_colour", light.sun);
    program.set("sky_colour", light.sky);
    program.set("horizon_colour", light.horizon);
    program.set("ground_colour", light.ground);
}

}  // namespace render
