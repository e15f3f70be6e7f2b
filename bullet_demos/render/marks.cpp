#include "render/marks.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace render {
namespace {

void attribute(GLuint index, GLint count, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, sizeof(Marks::Point),
                          reinterpret_cast<const void*>(offset));
}

}  // namespace

MarkBuffer::MarkBuffer() {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &buffer_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    attribute(0, 3, offsetof(Marks::Point, position));
    attribute(1, 3, offsetof(Marks::Point, colour));
    attribute(2, 1, offsetof(Marks::Point, radius));
    attribute(3, 1, offsetof(Marks::Point, opacity));
    glBindVertexArray(0);
}

MarkBuffer::~MarkBuffer() {
    glDeleteBuffers(1, &buffer_);
    glDeleteVertexArrays(1, &array_);
}

void MarkBuffer::draw(const std::vector<Marks::Point>& marks, std::uint32_t mode) const {
    if (marks.empty()) return;
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(marks.size() * sizeof(Marks::Point)), marks.data(),
                 GL_STREAM_DRAW);
    glDrawArrays(mode, 0, GLsizei(marks.size()));
}

}  // namespace render
