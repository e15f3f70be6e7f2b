#include "headless/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demo {
namespace {

constexpr double margin = 1.12;  ///< of the picture, so that nothing touches its frame

/// Two slanted planes that hold all points between them: |x - x_eye| <= slope (z - z_eye), z along the view.
struct Wedge {
    double x_eye = 0, z_eye = 0;

    Wedge(const std::vector<Vec3>& points, const Vec3& across, const Vec3& along, double slope) {
        double right = -std::numeric_limits<double>::infinity(), left = right;
        for (const Vec3& p : points) {
            const double x = across.dot(p), z = along.dot(p);
            right = std::max(right, x - slope * z);
            left = std::max(left, -x - slope * z);
        }
        x_eye = (right - left) / 2;
        z_eye = -(right + left) / (2 * slope);
    }
};

Vec3 mean(const std::vector<Vec3>& points) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

/// The points of all bodies but those that flew far from the rest, so that one chip does not make the whole
/// scene small.
std::vector<Vec3> withoutStrays(const std::vector<std::vector<Vec3>>& bodies) {
    constexpr double most = 0.85, reach = 1.8;
    std::vector<Vec3> points, kept;
    for (const auto& body : bodies) points.insert(points.end(), body.begin(), body.end());
    Vec3 middle;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Vec3& p : points) values.push_back(p[axis]);
        std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
        middle[axis] = values[values.size() / 2];
    }
    std::vector<double> distances;
    for (const Vec3& p : points) distances.push_back((p - middle).norm());
    std::sort(distances.begin(), distances.end());
    const double limit = reach * distances[static_cast<std::size_t>(most * (distances.size() - 1))];
    for (const auto& body : bodies)
        if ((mean(body) - middle).norm() <= limit) kept.insert(kept.end(), body.begin(), body.end());
    return kept.empty() ? points : kept;
}

}  // namespace

Viewpoint fitCamera(const Camera& camera, const std::vector<std::vector<Vec3>>& bodies, double aspect) {
    const std::vector<Vec3> points = withoutStrays(bodies);
    const Vec3 along = camera.towards.normalized();
    const Vec3 right = along.cross(Vec3::UnitZ()).normalized();
    const Vec3 up = right.cross(along);
    const double slope = std::tan(camera.width_deg / 2 * 3.14159265358979323846 / 180) / margin;
    const Wedge horizontal(points, right, along, slope), vertical(points, up, along, slope / aspect);
    Viewpoint view;
    view.position =
        horizontal.x_eye * right + vertical.x_eye * up + std::min(horizontal.z_eye, vertical.z_eye) * along;
    view.look_at = view.position + along;
    view.up = up;
    view.width_deg = camera.width_deg;
    return view;
}

}  // namespace demo
