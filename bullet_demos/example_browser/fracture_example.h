#pragma once

#include <CommonInterfaces/CommonRigidBodyBase.h>

#include <memory>
#include <optional>
#include <string>

#include "example_browser/body_graphics.h"
#include "example_browser/knobs.h"
#include "world/placed_scene.h"

namespace demo {

/// A scene in Bullet's example browser. The left mouse button drags bodies as in the other examples; the
/// right one, or the key `.`, shoots a ball; the button of the panel starts the scene again.
class FractureExample : public CommonRigidBodyBase {
  public:
    /// `knobs` outlive the example, so that they stay where they are when it is chosen again.
    FractureExample(GUIHelperInterface* helper, std::string scene_file, std::string meshes, Knobs& knobs);
    ~FractureExample() override;

    void initPhysics() override;
    void exitPhysics() override;
    void stepSimulation(float seconds) override;
    void resetCamera() override;
    bool mouseButtonCallback(int button, int state, float x, float y) override;
    bool keyboardCallback(int key, int state) override;

    void restart();
    void shoot(const btVector3& from, const btVector3& towards);

  private:
    void placeScene();
    void removeScene();
    void takeEvents();
    btVector3 cameraPosition() const;

    std::string scene_file_, meshes_;
    Knobs& knobs_;
    bool is_restart_wanted_ = false;
    std::optional<Scene> scene_;
    SceneAssets assets_;
    std::unique_ptr<BodyGraphics> graphics_;
    std::unique_ptr<PlacedScene> placed_;
};

}  // namespace demo
