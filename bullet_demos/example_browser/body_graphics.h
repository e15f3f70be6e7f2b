#pragma once

#include <map>
#include <tuple>

#include "world/placed_scene.h"

struct GUIHelperInterface;

namespace demo {

/// Has the browser draw the bodies of a scene: each breakable body with its own surface, floor and balls with
/// their collision shapes. The user index of a body is the number of its graphics instance, as the browser
/// expects.
class BodyGraphics {
  public:
    explicit BodyGraphics(GUIHelperInterface& helper) : helper_(helper) {}
    ~BodyGraphics();
    BodyGraphics(const BodyGraphics&) = delete;
    BodyGraphics& operator=(const BodyGraphics&) = delete;

    /// Fragments inherit the user index of the body that they come from; with this they have none at birth.
    static void watch(PlacedScene& scene);
    /// Draws those that are not drawn yet. The browser keeps the vertices of bodies that are gone: where it
    /// has no room for more, all bodies are drawn anew. What finds no room then waits until a body is
    /// removed.
    void addMissing(btDiscreteDynamicsWorld& world, const PlacedScene& scene);
    void remove(btRigidBody& body);
    void removeAll();

  private:
    bool tryToAddMissing(btDiscreteDynamicsWorld& world, const PlacedScene& scene);
    void forgetAll(btDiscreteDynamicsWorld& world);
    void addBreakable(btRigidBody& body, const PlacedScene& scene);
    void addPlain(btRigidBody& body);
    int textureOf(const Look& look);

    GUIHelperInterface& helper_;
    bool is_full_ = false;
    std::map<std::tuple<double, double, double, double, double, double>, int> textures_;  ///< by colours
};

}  // namespace demo
