#include "core/stress/surface_traction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace sherd {

SymmetricTensor withTraction(const SymmetricTensor& raw, const Vec3& normal, const Vec3& traction_pa,
                             const Elasticity& elasticity) {
    const Mat3 within = Mat3::Identity() - normal * normal.transpose();
    const Mat3 stress = toMatrix(raw);
    const double along = traction_pa.dot(normal);
    const double coupling =
        elasticity.lambda_pa / (elasticity.lambda_pa + 2 * elasticity.mu_pa);  // nu / (1 - nu)
    const Vec3 tangential = traction_pa - along * normal;
    return toSymmetricTensor(within * stress * within +
                             coupling * (along - normal.dot(stress * normal)) * within +
                             tangential * normal.transpose() + normal * tangential.transpose() +
                             along * normal * normal.transpose());
}

namespace {

/// Which points lie near a load. The loads are sorted into cubes as long as `reach`, so that a point is held
/// against those around it only.
class LoadedPlaces {
  public:
    LoadedPlaces(const std::vector<PointForce>& acting, double reach) : reach_(reach) {
        for (const PointForce& load : acting) {
            box_.extend(load.position);
            loads_.push_back({cubeOf(load.position), load.position});
        }
        std::sort(loads_.begin(), loads_.end(), [](const Load& a, const Load& b) { return a.cube < b.cube; });
    }

    bool isNear(const Vec3& x) const {
        if (loads_.empty() || box_.squaredExteriorDistance(x) > reach_ * reach_) return false;
        const Cube middle = cubeOf(x);
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j) {
                // The cubes of a row follow each other.
                const Cube first{middle[0] + i, middle[1] + j, middle[2] - 1},
                    last{first[0], first[1], middle[2] + 1};
                auto load = std::lower_bound(loads_.begin(), loads_.end(), first,
                                             [](const Load& a, const Cube& cube) { return a.cube < cube; });
                for (; load != loads_.end() && load->cube <= last; ++load)
                    if ((load->position - x).squaredNorm() < reach_ * reach_) return true;
            }
        return false;
    }

  private:
    using Cube = std::array<std::int64_t, 3>;
    struct Load {
        Cube cube;
        Vec3 position;
    };

    Cube cubeOf(const Vec3& x) const {
        const auto index = [&](int d) { return static_cast<std::int64_t>(std::floor(x[d] / reach_)); };
        return {index(0), index(1), index(2)};
    }

    double reach_;
    Eigen::AlignedBox3d box_;
    std::vector<Load> loads_;
};

}  // namespace

void freeSurface(const Discretisation& solid, const std::vector<PointForce>& acting,
                 const Elasticity& elasticity, std::vector<SymmetricTensor>& surface) {
    const LoadedPlaces loaded(acting, solid.spacing);
    for (std::size_t q = 0; q < surface.size(); ++q) {
        const SurfacePoint& point = solid.surface_points[q];
        if (point.normal.isZero() || loaded.isNear(point.position)) continue;
        surface[q] = withTraction(surface[q], point.normal, Vec3::Zero(), elasticity);
    }
}

}  // namespace sherd
