#include "render/renderer.h"

#include <epoxy/gl.h>

namespace render {

namespace {

constexpr int light_unit = 1, depth_unit = 2;

View viewOf(const OrbitCamera& camera, Size size) {
    const Mat4 turn = camera.view(), projection = camera.projection(size.aspect());
    return {camera.eye(),
            turn.block<1, 3>(0, 0).transpose(),
            turn.block<1, 3>(1, 0).transpose(),
            projection,
            projection * turn,
            camera.distance(),
            size};
}

}  // namespace

Renderer::Renderer() {
    glGenVertexArrays(1, &no_buffer_);
}

Renderer::~Renderer() {
    glDeleteVertexArrays(1, &no_buffer_);
}

void Renderer::resize(Size size, int samples) {
    if (picture_ && picture_->size() == size && samples_ == samples) return;
    samples_ = samples;
    light_ = std::make_unique<Target>(size, Target::Kind{true, true, samples});
    flat_light_ = std::make_unique<Target>(size, Target::Kind{true, true, 0});
    picture_ = std::make_unique<Target>(size, Target::Kind{});
}

void Renderer::draw(const Frame& frame, const OrbitCamera& camera, Size size, int samples) {
    resize(size, samples);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    const View view = viewOf(camera, size);
    shadows_.draw(frame, camera);

    light_->bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    drawBackground(frame, view);
    surfaces_.drawOpaque(frame, view, shadows_);
    darkenCorners(view);
    if (!frame.marks_through) drawMarks(frame, view);
    if (hasClearItems(frame)) {
        light_->resolveTo(*flat_light_, false);
        light_->bind();
        surfaces_.drawClear(frame, view, shadows_, *flat_light_);
    }
    if (frame.marks_through) drawMarks(frame, view);

    light_->resolveTo(*flat_light_, false);
    picture_->bind();
    glDisable(GL_DEPTH_TEST);
    tone_.use();
    flat_light_->bindColour(light_unit);
    tone_.set("light_map", light_unit);
    drawScreen();
}

void Renderer::drawBackground(const Frame& frame, const View& view) const {
    glDisable(GL_DEPTH_TEST);
    background_.use();
    setLight(background_, frame.light);
    background_.set("from_clip", Mat4(view.view_projection.inverse()));
    drawScreen();
    glEnable(GL_DEPTH_TEST);
}

void Renderer::darkenCorners(const View& view) const {
    light_->resolveTo(*flat_light_, true);
    light_->bind();
    const float reach = 0.05f * view.distance;
    occlusion_.use();
    flat_light_->bindDepth(depth_unit);
    occlusion_.set("depth_map", depth_unit);
    occlusion_.set("from_projection", Mat4(view.projection.inverse()));
    occlusion_.set("radius", Vec2(reach / 2 * view.projection(0, 0), reach / 2 * view.projection(1, 1)));
    occlusion_.set("reach", reach);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_COLOR, GL_ZERO);
    drawScreen();
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
}

void Renderer::drawMarks(const Frame& frame, const View& view) const {
    if (frame.marks.empty()) return;
    if (frame.marks_through) glDisable(GL_DEPTH_TEST);
    glEnable(GL_PROGRAM_POINT_SIZE);
    mark_.use();
    mark_.set("view_projection", view.view_projection);
    mark_.set("pixels_at_one_metre", float(view.size.height) / 2 * view.projection(1, 1));
    mark_.set("largest_pixels", 64.0f);
    mark_.set("soft", 0);
    mark_.set("round", 0);
    mark_buffer_.draw(frame.marks.ends, GL_LINES);
    if (frame.marks_through) glEnable(GL_DEPTH_TEST);
    mark_.set("round", 1);
    mark_buffer_.draw(frame.marks.points, GL_POINTS);
    drawPuffs(frame);
}

void Renderer::drawPuffs(const Frame& frame) const {
    mark_.set("largest_pixels", 255.0f);
    mark_.set("soft", 1);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    mark_buffer_.draw(frame.marks.puffs, GL_POINTS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void Renderer::drawScreen() const {
    glBindVertexArray(no_buffer_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace render
