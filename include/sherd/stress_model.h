#pragma once

#include <sherd/material.h>
#include <sherd/repair.h>
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

/// What it took to prepare a body for solves, and what came out.
struct StressModelReport {
    int particles = 0;
    int surface_points = 0;
    int unknowns = 0;
    /// Numbers that the factor of the stiffness matrix stores; a solve reads all of them twice.
    long long factor_entries = 0;
    long long factor_bytes = 0;  ///< memory that these take, 4 bytes each or 8
    /// Of the stiffness matrix, estimated from the factor's diagonal. Near 1e-16 the solve is worth nothing.
    double reciprocal_condition = 0;
    double spacing_m = 0;         ///< between particles
    double wall_thickness_m = 0;  ///< the tenth percentile of those that rays see from the surface inward
    double sample_ms = 0, assemble_ms = 0, factor_ms = 0;
    RepairReport repairs;               ///< what was changed in the mesh
    std::vector<std::string> warnings;  ///< what limits trust in the stresses, with the remedy
};

/// The stress in a body under any loads, without breaking it: sampled, assembled and factored once, then two
/// triangular solves for each set of loads. The same stress problem that a blow in a FractureWorld solves.
/// Cheap to copy; all members may be called from several threads at once.
class StressModel {
  public:
    /// Checks the surface, or mends it where `repair` allows that, samples the solid, and factors its stress
    /// problem. Where `supports` name parts of the surface the displacement is zero; without any, loads are
    /// balanced by rigid acceleration. Supports have to hold more than a point or a straight line. The error
    /// says what is wrong with the surface, a constant, a setting or a support, and what to do.
    static Result<StressModel> make(const TriangleMesh& surface, const Material& material,
                                    const Settings& settings = {},
                                    const std::vector<SurfaceRegion>& supports = {},
                                    const Repair& repair = {});

    /// Stress at the particles, at the surface points, and at `points` (m, in or on the solid) under `loads`
    /// and the inertia loads of a steady spin about the centre of mass. The stress at surface points agrees
    /// with the traction that acts there, which is zero away from the loads. The error says which region
    /// touches no surface, or which figure is not finite.
    Result<StressField> solve(const std::vector<SurfaceLoad>& loads, const std::vector<Vec3>& points = {},
                              const Vec3& spin_rad_s = Vec3::Zero()) const;

    const TriangleMesh& surface() const;
    const Settings& settings() const;  ///< as used: loads are always resampled here
    StressModelReport report() const;

    std::vector<Vec3> particlePositions() const;  ///< one a particle, m
    std::vector<double> particleVolumes() const;  ///< one a particle, m^3; they add up to the body's
    std::vector<Vec3> surfacePositions() const;   ///< one a surface point, m
    /// One a surface point, of unit length, outward; zero where the surface bends within a cell.
    std::vector<Vec3> surfaceNormals() const;

  private:
    StressModel(std::shared_ptr<const BreakableSolid> body, const RepairReport& repairs)
        : solid_(std::move(body)), repairs_(repairs) {}

    std::shared_ptr<const BreakableSolid> solid_;
    RepairReport repairs_;
};

}  // namespace sherd
