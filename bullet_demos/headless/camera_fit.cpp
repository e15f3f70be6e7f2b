#include "camera_fit.h"

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

/// Leaves out what flew far from the rest, so that one chip does not make the whole scene small.
std::vector<Vec3> withoutStrays(const std::vector<Vec3>& points) {
    constexpr double most = 0.85, reach = 2;
    Vec3 middle;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Vec3& p : points) values.push_back(p[axis]);
        std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
        middle[axis] = values[values.size() / 2];
    }
    std::vector<double> distances;
    for (const Vec3& p : points) distances.push_back((p - middle).norm());
    std::vector<double> sorted = distances;
    std::sort(sorted.begin(), sorted.end());
    const double limit = reach * sorted[static_cast<std::size_t>(most * (sorted.size() - 1))];
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (distances[i] <= limit) kept.push_back(points[i]);
    return kept;
}

}  // namespace

Viewpoint fitCamera(const Camera& camera, const std::vector<Vec3>& all, double aspect) {
    const std::vector<Vec3> points = withoutStrays(all);
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
