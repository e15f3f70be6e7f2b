#include "render/shadow_pass.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "render/projection.h"

namespace render {
namespace {

/// What the shadow map covers: all items near what the camera looks at.
Bounds shadowBounds(const Frame& frame, const OrbitCamera& camera) {
    Bounds bounds;
    for (const Item& item : frame.items) {
        if (item.is_ground) continue;
        const Bounds own = item.bounds();
        if ((own.centre() - camera.target()).norm() - own.radius() > 2 * camera.distance()) continue;
        bounds.add(own.lo);
        bounds.add(own.hi);
    }
    return bounds;
}

}  // namespace

void ShadowPass::draw(const Frame& frame, const OrbitCamera& camera) {
    const Bounds bounds = shadowBounds(frame, camera);
    const float radius = std::max(1.05f * bounds.radius(), 1e-3f);
    const Vec3 centre = bounds.empty() ? Vec3(camera.target()) : bounds.centre();
    const Vec3 sun = centre - 2 * radius * frame.light.towards;
    to_shadow_ = orthographic(radius, radius, 0.5f * radius, 6 * radius) * lookAt(sun, centre, Vec3::UnitX());
    map_.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    program_.use();
    program_.set("to_shadow", to_shadow_);
    for (const Item& item : frame.items) {
        if (item.is_ground) continue;
        program_.set("model", item.place);
        program_.set("clear", item.material.clear);
        item.mesh->draw();
    }
}

}  // namespace render
