#include "viewer/shape_lines.h"

#include "viewer/conversions.h"

namespace demo {
namespace {

/// Bullet's way to have things drawn, of which lines are all that is wanted.
class LineDrawer : public btIDebugDraw {
  public:
    explicit LineDrawer(render::Marks& marks) : marks_(marks) {}
    void drawLine(const btVector3& from, const btVector3& to, const btVector3& colour) override {
        marks_.line(toRender(from), toRender(to), toRender(colour));
    }
    void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
    void reportErrorWarning(const char*) override {}
    void draw3dText(const btVector3&, const char*) override {}
    void setDebugMode(int) override {}
    int getDebugMode() const override { return DBG_DrawWireframe; }

  private:
    render::Marks& marks_;
};

}  // namespace

void addShapeLines(render::Marks& marks, btDiscreteDynamicsWorld& world,
                   const sherd::FractureWorld& fracture) {
    LineDrawer drawer(marks);
    btIDebugDraw* const before = world.getDebugDrawer();
    world.setDebugDrawer(&drawer);
    for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
        const btRigidBody* body = btRigidBody::upcast(world.getCollisionObjectArray()[i]);
        if (!body || (body->isStaticObject() && !fracture.asset(body))) continue;  // the floor
        const btVector3 colour = body->isActive() ? btVector3(1, 1, 1) : btVector3(0.3f, 0.8f, 0.4f);
        world.debugDrawObject(body->getWorldTransform(), body->getCollisionShape(), colour);
    }
    world.setDebugDrawer(before);
}

}  // namespace demo
