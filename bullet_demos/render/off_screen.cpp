#include <epoxy/egl.h>

#include "render/context.h"

namespace render {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw Failure(what +
                  ". Pictures without a window need EGL without a surface, as Mesa has it (libegl-mesa0).");
}

/// Mesa's platform without a display; its software driver is enough.
EGLDisplay displayWithoutScreen() {
    if (!epoxy_has_egl() || !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base"))
        fail("There is no EGL here");
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

class OffScreen : public Context {
  public:
    explicit OffScreen(Size size) : size_(size), display_(displayWithoutScreen()) {
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
            fail("EGL cannot start without a display");
        const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                 EGL_NONE};
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_CONTEXT_OPENGL_DEBUG,
                                  EGL_TRUE,
                                  EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        eglBindAPI(EGL_OPENGL_API);
        eglChooseConfig(display_, wanted, &config, 1, &count);
        context_ = eglCreateContext(display_, count > 0 ? config : nullptr, EGL_NO_CONTEXT, version);
        if (context_ == EGL_NO_CONTEXT || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            fail("EGL has no OpenGL 3.3");
    }
    ~OffScreen() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }

    Size size() const override { return size_; }
    GLFWwindow* window() const override { return nullptr; }
    bool closed() override { return false; }
    void show() override {}

  private:
    Size size_;
    EGLDisplay display_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> Context::offScreen(Size size) {
    return std::make_unique<OffScreen>(size);
}

}  // namespace render
