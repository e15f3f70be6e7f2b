#pragma once

#include <sherd/material.h>
#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/stress_field.h>
#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace sherd {

class BreakableSolid;  // internal: the sampled solid

/// What preparing a body took and gave.
struct StressModelReport {
    int particles = 0;
    int surface_points = 0;
    int unknowns = 0;
    long long factor_entries = 0;     ///< stored entries of the factor; a solve streams them once a triangle
    long long factor_bytes = 0;       ///< memory of the factor's values
    double reciprocal_condition = 0;  ///< of the stiffness matrix, estimated from the factor's diagonal
    double spacing_m = 0;             ///< between particles
    double wall_thickness_m = 0;      ///< of the thinnest walls
    double sample_ms = 0, assemble_ms = 0, factor_ms = 0;
    std::vector<std::string> warnings;  ///< what limits trust in the stresses, with the remedy
};

/// The stress in a body under any loads, without breaking it: sampled, assembled and factored once, then two
/// triangular solves a load case. The same stress problem that a blow in a FractureWorld solves. Cheap to
/// copy.
class StressModel {
  public:
    /// Checks the surface, samples the solid, and factors its stress problem. Where `supports` name parts of
    /// the surface the displacement is zero; without any, loads are balanced by rigid acceleration. The error
    /// says what is wrong with the surface, a constant, a setting or a support, and what to do.
    static Result<StressModel> make(const TriangleMesh& surface, const Material& material,
                                    const Settings& settings = {},
                                    const std::vector<SurfaceRegion>& supports = {});

    /// Stress at the particles, at the surface points, and at `points` (m, in or on the solid) under `loads`
    /// and the inertia loads of a steady spin about the centre of mass. On the surface it carries the
    /// traction that acts there, none where nothing does. The error says which region touches no surface, or
    /// which figure is not finite.
    Result<StressField> solve(const std::vector<SurfaceLoad>& loads, const std::vector<Vec3>& points = {},
                              const Vec3& spin_rad_s = Vec3::Zero()) const;

    const TriangleMesh& surface() const;
    const Settings& settings() const;
    StressModelReport report() const;

    std::vector<Vec3> particlePositions() const;  ///< #particles, m
    std::vector<double> particleVolumes() const;  ///< #particles, m^3; they add up to the body's
    std::vector<Vec3> surfacePositions() const;   ///< #surface points, m
    std::vector<Vec3> surfaceNormals()
        const;  ///< #surface points, unit, outward; zero where curved within a cell

  private:
    explicit StressModel(std::shared_ptr<const BreakableSolid> body) : solid_(std::move(body)) {}

    std::shared_ptr<const BreakableSolid> solid_;
};

}  // namespace sherd
