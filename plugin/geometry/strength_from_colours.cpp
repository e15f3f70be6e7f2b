#include <sherd/strength_field.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "geometry/triangle_tree.h"

namespace sherd {

namespace {

struct PaintedSurface {
    TriangleMesh mesh;
    TriangleTree tree;

    explicit PaintedSurface(const TriangleMesh& painted) : mesh(painted), tree(mesh) {
        tree.prepareNearest();
    }

    /// Mean of the colour's three channels at the surface point nearest to x.
    double brightnessNear(const Vec3& x) const {
        const auto [p, triangle] = tree.nearest(x);
        const auto& corners = mesh.triangles[triangle];
        const Vec3 &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]],
                   &c = mesh.vertices[corners[2]];
        const Vec3 weights((b - p).cross(c - p).norm(), (c - p).cross(a - p).norm(),
                           (a - p).cross(b - p).norm());
        Vec3 colour = Vec3::Zero();
        for (int i = 0; i < 3; ++i) colour += weights[i] / weights.sum() * mesh.colours[corners[i]];
        return colour.mean();
    }
};

}  // namespace

Result<std::function<double(const Vec3& x)>> strengthFromColours(const TriangleMesh& painted, double black,
                                                                 double white) {
    if (painted.triangles.empty() || painted.colours.size() != painted.vertices.size())
        return Error{
            "The mesh has no vertex colours; give its vertices red, green and blue after x, y and z."};
    if (!(black > 0 && white > 0) || !std::isfinite(black) || !std::isfinite(white))
        return Error{"The strength of black or white parts is not above 0 and finite."};
    const auto surface = std::make_shared<const PaintedSurface>(painted);
    return std::function<double(const Vec3&)>([=](const Vec3& x) {
        const double strength = black + (white - black) * surface->brightnessNear(x);
        return std::clamp(strength, std::min(black, white), std::max(black, white));  // rounding
    });
}

}  // namespace sherd
