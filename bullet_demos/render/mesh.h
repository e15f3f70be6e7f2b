#pragma once

#include <cstdint>
#include <vector>

#include "render/types.h"

namespace render {

/// A corner of a triangle.
struct Vertex {
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    Vec3 colour = Vec3::Ones();  ///< multiplies the material's
    float inside = 0;            ///< 1: on a face of a break
};

/// Triangles, three corners each.
struct MeshData {
    std::vector<Vertex> corners;

    Bounds bounds() const;
};

MeshData sphereMesh(float radius, int rings = 24);
/// A square of the plane z = 0.
MeshData squareMesh(float half_width);

/// Triangles in the memory of the graphics card.
class Mesh {
  public:
    explicit Mesh(const MeshData& data);
    ~Mesh();
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;

    void draw() const;
    const Bounds& bounds() const { return bounds_; }  ///< in its own coordinates

  private:
    std::uint32_t array_ = 0, buffer_ = 0;
    int count_ = 0;
    Bounds bounds_;
};

}  // namespace render
