#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>

#include <utility>

#include "render/context.h"

namespace render {
namespace {

class Window : public Context {
  public:
    Window(Size size, const std::string& title) {
        if (!glfwInit()) fail("No window can be opened");
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
        window_ = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
        if (!window_) fail("No window with OpenGL 3.3 can be opened");
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window_, this);
        glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
            if (action != GLFW_RELEASE)
                static_cast<Window*>(glfwGetWindowUserPointer(window))->pressed_.push_back(key);
        });
    }
    ~Window() override {
        if (window_) glfwDestroyWindow(window_);
        glfwTerminate();
    }

    Size size() const override {
        Size size;
        glfwGetFramebufferSize(window_, &size.width, &size.height);
        return size;
    }
    GLFWwindow* window() const override { return window_; }
    bool closed() override {
        glfwPollEvents();
        return glfwWindowShouldClose(window_);
    }
    std::vector<int> takePressedKeys() override { return std::exchange(pressed_, {}); }
    void show() override { glfwSwapBuffers(window_); }

  private:
    [[noreturn]] static void fail(const std::string& what) {
        const char* why = nullptr;
        glfwGetError(&why);
        const std::string reason = why ? std::string(": ") + why : "";
        glfwTerminate();
        throw Failure(
            what + reason +
            ". A machine without a display can still draw to files: --off-screen --screenshot FILE, with "
            "--steps 240 of a scene, --script-seconds 3 of the game.");
    }

    GLFWwindow* window_ = nullptr;
    std::vector<int> pressed_;
};

}  // namespace

std::unique_ptr<Context> Context::inWindow(Size size, const std::string& title) {
    return std::make_unique<Window>(size, title);
}

std::string contextDescription() {
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return std::string(value ? reinterpret_cast<const char*>(value) : "?");
    };
    return "OpenGL " + text(GL_VERSION) + ", " + text(GL_RENDERER);
}

bool isSoftware() {
    const std::string description = contextDescription();
    return description.find("llvmpipe") != std::string::npos ||
           description.find("softpipe") != std::string::npos;
}

}  // namespace render
