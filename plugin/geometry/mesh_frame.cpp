#include "geometry/mesh_frame.h"

#include <cmath>

#include "geometry/sentences.h"

namespace sherd {
namespace {

/// A proper rotation that takes `up_axis` to z; it only swaps and negates, so nothing is rounded.
Vec3 turned(const Vec3& v, UpAxis up_axis) {
    if (up_axis == UpAxis::x) return {-v.z(), v.y(), v.x()};
    if (up_axis == UpAxis::y) return {v.x(), -v.z(), v.y()};
    return v;
}

}  // namespace

Status checkScale(double scale) {
    if (std::isfinite(scale) && scale > 0) return success();
    return Error{"The scale of the mesh (Repair::scale) is " + threeDigits(scale) +
                 "; it multiplies coordinates and must be above 0 and finite."};
}

TriangleMesh placed(TriangleMesh mesh, double scale, UpAxis up_axis) {
    for (Vec3& vertex : mesh.vertices) vertex = turned(scale * vertex, up_axis);
    for (auto& corners : mesh.normals)
        for (Vec3& normal : corners) normal = turned(normal, up_axis);
    return mesh;
}

}  // namespace sherd
