#pragma once

class btCollisionShape;
class btDiscreteDynamicsWorld;
class btRigidBody;
class btVector3;
struct CommonParameterInterface;
struct CommonRenderInterface;

struct GUIHelperInterface {
    virtual ~GUIHelperInterface() = default;
    virtual void createRigidBodyGraphicsObject(btRigidBody* body, const btVector3& colour) = 0;
    virtual void createCollisionShapeGraphicsObject(btCollisionShape* shape) = 0;
    virtual void createPhysicsDebugDrawer(btDiscreteDynamicsWorld* world) = 0;
    virtual void syncPhysicsToGraphics(const btDiscreteDynamicsWorld* world) = 0;
    virtual int registerTexture(const unsigned char* texels, int width, int height) = 0;
    virtual void removeTexture(int) {}
    virtual int registerGraphicsShape(const float* vertices, int vertex_count, const int* indices,
                                      int index_count, int primitive, int texture) = 0;
    virtual int registerGraphicsInstance(int shape, const float* position, const float* quaternion,
                                         const float* colour, const float* scaling) = 0;
    virtual void removeAllGraphicsInstances() = 0;
    virtual void removeGraphicsInstance(int) {}
    virtual CommonParameterInterface* getParameterInterface() = 0;
    virtual CommonRenderInterface* getRenderInterface() = 0;
    virtual void setUpAxis(int axis) = 0;
    virtual void resetCamera(float distance, float yaw, float pitch, float x, float y, float z) = 0;
};
