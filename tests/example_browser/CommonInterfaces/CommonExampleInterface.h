#pragma once

// What the examples of this tree need of Bullet's example browser, to build and test them where it is not:
// these headers have the names of the browser's, and declare no more than is used.

struct GUIHelperInterface;

struct CommonExampleOptions {
    explicit CommonExampleOptions(GUIHelperInterface* helper, int option = 0)
        : m_guiHelper(helper), m_option(option) {}
    GUIHelperInterface* m_guiHelper;
    int m_option;
};

class CommonExampleInterface {
  public:
    typedef CommonExampleInterface*(CreateFunc)(CommonExampleOptions& options);
    virtual ~CommonExampleInterface() = default;
    virtual void initPhysics() = 0;
    virtual void exitPhysics() = 0;
    virtual void stepSimulation(float seconds) = 0;
    virtual void renderScene() = 0;
    virtual void resetCamera() {}
    virtual bool mouseButtonCallback(int button, int state, float x, float y) = 0;
    virtual bool keyboardCallback(int key, int state) = 0;
};
