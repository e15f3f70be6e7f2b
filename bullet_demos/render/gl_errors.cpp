#include "render/gl_errors.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace render {
namespace {

void takeMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text,
                 const void* errors) {
    if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
    static_cast<GlErrors*>(const_cast<void*>(errors))->add(text);
}

const char* name(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "another error";
    }
}

bool hasMessages() {
    return epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug");
}

}  // namespace

GlErrors::GlErrors() {
    if (!hasMessages()) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(takeMessage, this);
}

GlErrors::~GlErrors() {
    if (hasMessages()) glDebugMessageCallback(nullptr, nullptr);
}

void GlErrors::check() {
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
        add(std::string("glGetError: ") + name(error));
}

void GlErrors::add(const std::string& message) {
    constexpr std::size_t most = 20;
    if (messages_.size() < most && std::find(messages_.begin(), messages_.end(), message) == messages_.end())
        messages_.push_back(message);
}

}  // namespace render
