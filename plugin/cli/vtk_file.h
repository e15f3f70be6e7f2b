#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <string>
#include <vector>

namespace sherd::cli {

/// Particles and the surface around them, with their stress.
struct StressPicture {
    std::vector<Vec3> particles;                     ///< m
    std::vector<double> particle_volumes;            ///< m^3
    std::vector<SymmetricTensor> particle_stresses;  ///< Pa
    TriangleMesh surface;
    std::vector<SymmetricTensor> vertex_stresses;  ///< Pa, at the vertices of the surface
};

/// Writes one unstructured grid for ParaView: a vertex cell a particle, a triangle a triangle of the surface.
/// Point data: stress (Pa, 9 components), max_principal, von_mises (Pa), volume (m^3; 0 at the surface) and
/// part (0 particle, 1 surface; threshold by it). Legacy text for a name that ends in .vtk, XML for .vtu.
Status writeVtk(const StressPicture& picture, const std::string& path);

}  // namespace sherd::cli
