#pragma once

#include <CommonInterfaces/CommonGUIHelperInterface.h>
#include <CommonInterfaces/CommonParameterInterface.h>
#include <CommonInterfaces/CommonRenderInterface.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

/// A browser without a window: it keeps what examples register, and complains of what a real one would
/// stumble over.
class RecordingBrowser : public GUIHelperInterface,
                         public CommonParameterInterface,
                         public CommonRenderInterface,
                         public CommonCameraInterface {
  public:
    std::set<int> instances, textures, shapes;
    std::vector<SliderParams> sliders;
    std::vector<ButtonParams> buttons;
    int shape_tries = 0;
    /// Room for vertices. They stay until all instances are removed, as do those that found no room.
    long capacity = std::numeric_limits<long>::max(), vertices_kept = 0;
    float camera_distance = 0;

    void createRigidBodyGraphicsObject(btRigidBody* body, const btVector3& colour) override {
        EXPECT_GT(colour.w(), 0) << "invisible";
        const int shape = body->getCollisionShape()->getUserIndex();
        if (shape < 0) return;
        EXPECT_TRUE(shapes.count(shape)) << "a shape that was not registered";
        body->setUserIndex(addInstance());
    }
    void createCollisionShapeGraphicsObject(btCollisionShape* shape) override {
        if (shape->getUserIndex() < 0) shape->setUserIndex(addShape(24));
    }
    void createPhysicsDebugDrawer(btDiscreteDynamicsWorld*) override {}
    void syncPhysicsToGraphics(const btDiscreteDynamicsWorld*) override {}
    int registerTexture(const unsigned char*, int, int) override {
        textures.insert(++next_);
        return next_;
    }
    void removeTexture(int texture) override { EXPECT_EQ(textures.erase(texture), 1u); }
    int registerGraphicsShape(const float* vertices, int vertex_count, const int* indices, int index_count,
                              int primitive, int texture) override {
        EXPECT_EQ(primitive, B3_GL_TRIANGLES);
        EXPECT_EQ(index_count % 3, 0);
        EXPECT_TRUE(textures.count(texture));
        EXPECT_LT(*std::max_element(indices, indices + index_count), vertex_count);
        EXPECT_NEAR(btVector3(vertices[4], vertices[5], vertices[6]).length(), 1, 1e-4) << "a normal";
        return addShape(vertex_count);
    }
    int registerGraphicsInstance(int shape, const float*, const float*, const float*, const float*) override {
        EXPECT_TRUE(shapes.count(shape));
        return addInstance();
    }
    void removeAllGraphicsInstances() override {
        instances.clear();
        shapes.clear();
        vertices_kept = 0;
    }
    void removeGraphicsInstance(int instance) override { EXPECT_EQ(instances.erase(instance), 1u); }
    CommonParameterInterface* getParameterInterface() override { return this; }
    CommonRenderInterface* getRenderInterface() override { return this; }
    void setUpAxis(int axis) override { EXPECT_EQ(axis, 2); }
    void resetCamera(float distance, float, float, float, float, float) override {
        camera_distance = distance;
    }

    void registerSliderFloatParameter(SliderParams& slider) override { sliders.push_back(slider); }
    void registerButtonParameter(ButtonParams& button) override { buttons.push_back(button); }
    CommonCameraInterface* getActiveCamera() override { return this; }
    void getCameraPosition(float position[3]) const override { put(position, {0, -2, 0.5f}); }
    void getCameraTargetPosition(float position[3]) const override { put(position, {0, 0, 0.5f}); }

  private:
    static void put(float position[3], const std::vector<float>& values) {
        std::copy(values.begin(), values.end(), position);
    }
    int addShape(int vertex_count) {
        ++shape_tries;
        vertices_kept += vertex_count;
        if (vertices_kept >= capacity) return -1;
        shapes.insert(++next_);
        return next_;
    }
    int addInstance() {
        instances.insert(++next_);
        return next_;
    }
    int next_ = 0;
};
