#pragma once

#include <CommonInterfaces/CommonExampleInterface.h>
#include <CommonInterfaces/CommonGUIHelperInterface.h>
#include <CommonInterfaces/CommonRenderInterface.h>
#include <btBulletDynamicsCommon.h>

#include <memory>

/// A world that examples fill, and a body that the mouse holds.
struct CommonRigidBodyBase : public CommonExampleInterface {
    explicit CommonRigidBodyBase(GUIHelperInterface* helper) : m_guiHelper(helper) {}

    virtual void createEmptyDynamicsWorld() {
        parts_ = std::make_unique<Parts>();
        m_dynamicsWorld = &parts_->world;
    }
    /// As in the browser, who still has a body in the world loses it.
    void exitPhysics() override {
        removePickingConstraint();
        while (m_dynamicsWorld && m_dynamicsWorld->getNumCollisionObjects() > 0) {
            btCollisionObject* left = m_dynamicsWorld->getCollisionObjectArray()[0];
            m_dynamicsWorld->removeCollisionObject(left);
            delete left;
        }
        m_dynamicsWorld = nullptr;
        parts_.reset();
    }
    void renderScene() override { m_guiHelper->syncPhysicsToGraphics(m_dynamicsWorld); }
    bool mouseButtonCallback(int, int, float, float) override { return false; }
    bool keyboardCallback(int, int) override { return false; }
    btVector3 getRayTo(int, int) { return btVector3(0, 1000, 0); }

    void hold(btRigidBody* body) {
        m_pickedBody = body;
        held_by_ = std::make_unique<btPoint2PointConstraint>(*body, btVector3(0, 0, 0));
        m_dynamicsWorld->addConstraint(held_by_.get(), true);
    }
    virtual void removePickingConstraint() {
        if (!held_by_) return;
        m_pickedBody->activate();
        m_dynamicsWorld->removeConstraint(held_by_.get());
        held_by_.reset();
        m_pickedBody = nullptr;
    }

    btDiscreteDynamicsWorld* m_dynamicsWorld = nullptr;
    btRigidBody* m_pickedBody = nullptr;
    GUIHelperInterface* m_guiHelper;

  private:
    struct Parts {
        btDefaultCollisionConfiguration configuration;
        btCollisionDispatcher dispatcher{&configuration};
        btDbvtBroadphase broadphase;
        btSequentialImpulseConstraintSolver solver;
        btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    };
    std::unique_ptr<Parts> parts_;
    std::unique_ptr<btPoint2PointConstraint> held_by_;
};
