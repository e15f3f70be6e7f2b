#pragma once

#include <sherd/triangle_mesh.h>
#include <sherd/types.h>

#include <memory>
#include <vector>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// Volume, centroid and second moment of a piece of the solid, of unit density.
struct Moments {
    double volume = 0;             ///< m^3
    Vec3 centroid = Vec3::Zero();  ///< m
    Mat3 second = Mat3::Zero();    ///< integral of (x - centroid)(x - centroid)^T, m^5
};

/// A piece of the solid over which particle forms smooth the strain and masses are summed: a voxel cut by the
/// surface, or several merged.
struct IntegrationCell {
    Moments moments;
    int particle = -1;  ///< whose sub-domain it is part of; the sub-domains tile the solid
};

/// The face that two integration cells share; faces and surface points together close every cell:
/// the sum of area vectors is zero, the sum of area (x) centroid is volume times identity.
struct IntegrationFace {
    int cells[2] = {-1, -1};
    Vec3 area = Vec3::Zero();      ///< area times the unit normal, from cells[0] to cells[1], m^2
    Vec3 centroid = Vec3::Zero();  ///< m
};

/// A quadrature point of the solid's surface inside one integration cell.
struct SurfacePoint {
    int cell = -1;
    Vec3 position = Vec3::Zero();  ///< m
    Vec3 area = Vec3::Zero();      ///< weight, m^2: sum f(position) area is the integral of f n for linear f
    Vec3 normal =
        Vec3::Zero();  ///< outward, unit; zero where the surface in the cell is curved or the point is off it
};

struct Particle {
    Vec3 position = Vec3::Zero();  ///< centroid of its sub-domain, m
    double volume = 0;             ///< of its sub-domain, m^3
    double spacing = 0;            ///< local distance between particles, m; supports are multiples of it
};

/// A solid sampled for the stress solve: particles, and cells that tile it exactly. All that the solvers know
/// of the body's geometry.
struct Discretisation {
    double spacing = 0;             ///< m
    Vec3 cell_size = Vec3::Zero();  ///< edges of a cell of the integration grid, m
    std::vector<Particle> particles;
    std::vector<IntegrationCell> cells;
    std::vector<IntegrationFace> faces;  ///< between different cells only
    std::vector<SurfacePoint> surface_points;
    std::vector<Mat3> facing;  ///< per particle: integral of n n^T over its surface, n the unit normal, m^2
    std::vector<std::vector<int>> neighbours;      ///< per particle: who shares a face with it, sorted
    std::vector<std::vector<int>> particle_cells;  ///< per particle: its integration cells, sorted

    /// A voxel of the integration grid that holds solid; collision shapes are made of these.
    struct Voxel {
        Eigen::Vector3i index;  ///< on the integration grid
        int cell = -1;          ///< the integration cell that it belongs to
        double fill = 0;        ///< part of it that is solid, 0 to 1
    };
    std::shared_ptr<const TriangleMesh> surface;  ///< that was sampled
    CellParts parts;                  ///< the same solid, for trial functions that live on the grid
    Vec3 grid_origin = Vec3::Zero();  ///< corner of voxel (0, 0, 0), m
    std::vector<Voxel> voxels;        ///< in ascending order of (z, y, x)
};

double meanParticleVolume(const Discretisation& solid);  ///< m^3

}  // namespace sherd
