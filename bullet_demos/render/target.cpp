#include "render/target.h"

#include <epoxy/gl.h>

namespace render {
namespace {

void requireComplete() {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Failure(
            "The graphics driver cannot draw to a picture of this size and kind; make the window smaller.");
}

}  // namespace

Target::Target(Size size, Kind kind) : size_(size), kind_(kind) {
    glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    colour_ = attach(GL_COLOR_ATTACHMENT0, kind.light ? GL_RGBA16F : GL_RGBA8);
    if (kind.depth) depth_ = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24);
    requireComplete();
}

std::uint32_t Target::attach(std::uint32_t attachment, std::uint32_t format) const {
    const bool is_depth = attachment == GL_DEPTH_ATTACHMENT, multi = kind_.samples > 0;
    const GLenum kind = multi ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(kind, texture);
    if (multi) {
        glTexImage2DMultisample(kind, kind_.samples, format, size_.width, size_.height, GL_TRUE);
    } else {
        glTexImage2D(kind, 0, GLint(format), size_.width, size_.height, 0,
                     is_depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, nullptr);
        const GLint filter = is_depth ? GL_NEAREST : GL_LINEAR;
        glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(kind, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(kind, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, kind, texture, 0);
    return texture;
}

Target::~Target() {
    glDeleteFramebuffers(1, &frame_);
    glDeleteTextures(1, &colour_);
    if (depth_) glDeleteTextures(1, &depth_);
}

void Target::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glViewport(0, 0, size_.width, size_.height);
}

void Target::resolveTo(const Target& other, bool with_depth) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, other.frame_);
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    if (!with_depth) return;
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
}

void Target::copyToWindow(Size window) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, window.width, window.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

void Target::bindColour(int unit) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, colour_);
}

void Target::bindDepth(int unit) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, depth_);
}

ShadowMap::ShadowMap(int width) : width_(width) {
    glGenTextures(1, &depth_);
    glBindTexture(GL_TEXTURE_2D, depth_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width, width, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    requireComplete();
}

ShadowMap::~ShadowMap() {
    glDeleteFramebuffers(1, &frame_);
    glDeleteTextures(1, &depth_);
}

void ShadowMap::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glViewport(0, 0, width_, width_);
}

void ShadowMap::bindDepth(int unit) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, depth_);
}

}  // namespace render
