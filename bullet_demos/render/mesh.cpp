#include "render/mesh.h"

#include <epoxy/gl.h>

#include <cmath>
#include <cstddef>

namespace render {
namespace {

void attribute(GLuint index, GLint count, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offset));
}

Vertex onSphere(float radius, float along, float down) {
    Vertex vertex;
    vertex.normal = Vec3(std::sin(down) * std::cos(along), std::sin(down) * std::sin(along), std::cos(down));
    vertex.position = radius * vertex.normal;
    return vertex;
}

}  // namespace

Bounds MeshData::bounds() const {
    Bounds bounds;
    for (const Vertex& corner : corners) bounds.add(corner.position);
    return bounds;
}

MeshData sphereMesh(float radius, int rings) {
    constexpr float pi = 3.14159265f;
    const float step = pi / float(rings);
    MeshData mesh;
    for (int ring = 0; ring < rings; ++ring)
        for (int side = 0; side < 2 * rings; ++side) {
            const float down = step * float(ring), along = step * float(side);
            const Vertex a = onSphere(radius, along, down), b = onSphere(radius, along, down + step),
                         c = onSphere(radius, along + step, down + step),
                         d = onSphere(radius, along + step, down);
            mesh.corners.insert(mesh.corners.end(), {a, b, c, a, c, d});
        }
    return mesh;
}

MeshData squareMesh(float half_width) {
    MeshData mesh;
    for (const Vec2& at : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
        Vertex corner;
        corner.position = half_width * Vec3(at.x(), at.y(), 0);
        mesh.corners.push_back(corner);
    }
    return mesh;
}

Mesh::Mesh(const MeshData& data) : count_(int(data.corners.size())), bounds_(data.bounds()) {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &buffer_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(data.corners.size() * sizeof(Vertex)), data.corners.data(),
                 GL_STATIC_DRAW);
    attribute(0, 3, offsetof(Vertex, position));
    attribute(1, 3, offsetof(Vertex, normal));
    attribute(2, 3, offsetof(Vertex, colour));
    attribute(3, 1, offsetof(Vertex, inside));
    glBindVertexArray(0);
}

Mesh::~Mesh() {
    glDeleteBuffers(1, &buffer_);
    glDeleteVertexArrays(1, &array_);
}

void Mesh::draw() const {
    glBindVertexArray(array_);
    glDrawArrays(GL_TRIANGLES, 0, count_);
}

}  // namespace render
