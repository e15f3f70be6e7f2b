#pragma once

#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"

/// Solids with particles only, and random labels, for tests of the fragment surfaces.
namespace sherd::fragment_support {

/// Heights at which the vertical line through (x, y) goes through the surface, ascending.
inline std::vector<double> heightsAbove(const TriangleMesh& mesh, double x, double y) {
    std::vector<double> heights;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        if (x < std::min({p.x(), q.x(), r.x()}) || x > std::max({p.x(), q.x(), r.x()})) continue;
        if (y < std::min({p.y(), q.y(), r.y()}) || y > std::max({p.y(), q.y(), r.y()})) continue;
        const auto area = [&](const Vec3& s, const Vec3& t) {
            return (s.x() - x) * (t.y() - y) - (s.y() - y) * (t.x() - x);
        };
        const double u = area(q, r), v = area(r, p), w = area(p, q);
        if ((u > 0) != (v > 0) || (v > 0) != (w > 0)) continue;
        heights.push_back((u * p.z() + v * q.z() + w * r.z()) / (u + v + w));
    }
    std::sort(heights.begin(), heights.end());
    return heights;
}

/// One particle in the middle of every cell whose middle is inside the solid. Neighbours are those one cell
/// away.
inline Discretisation particlesOnly(const TriangleMesh& mesh, double spacing) {
    Vec3 low = mesh.vertices[0], high = low;
    for (const Vec3& v : mesh.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
    const Eigen::Vector3i count =
        ((high - low) / spacing - Vec3::Constant(1e-9)).array().ceil().max(1).cast<int>();
    Discretisation solid;
    solid.spacing = spacing;
    const Vec3 origin = (low + high - count.cast<double>() * spacing) / 2;
    for (int i = 0; i < count.x(); ++i)
        for (int j = 0; j < count.y(); ++j) {
            // Off the symmetry planes by a hair, so that lines miss vertices.
            const double x = origin.x() + (i + 0.5 + 1.3e-5) * spacing,
                         y = origin.y() + (j + 0.5 + 2.1e-5) * spacing;
            const std::vector<double> heights = heightsAbove(mesh, x, y);
            for (int k = 0; k < count.z(); ++k) {
                const double z = origin.z() + (k + 0.5) * spacing;
                const auto below = std::lower_bound(heights.begin(), heights.end(), z) - heights.begin();
                if (below % 2 == 0) continue;
                Particle particle;
                particle.position = {x, y, z};
                particle.volume = std::pow(spacing, 3);
                particle.spacing = spacing;
                solid.particles.push_back(particle);
            }
        }
    solid.neighbours.resize(solid.particles.size());
    for (std::size_t a = 0; a < solid.particles.size(); ++a)
        for (std::size_t b = 0; b < solid.particles.size(); ++b)
            if (a != b && (solid.particles[a].position - solid.particles[b].position).norm() < 1.1 * spacing)
                solid.neighbours[a].push_back(static_cast<int>(b));
    return solid;
}

/// Voronoi clusters of random particles.
inline FragmentLabels randomClusters(const Discretisation& solid, int count, unsigned seed) {
    std::mt19937 random(seed);
    FragmentLabels labels;
    labels.count = std::min<int>(count, static_cast<int>(solid.particles.size()));
    std::vector<int> seeds;
    while (static_cast<int>(seeds.size()) < labels.count) {
        const int s = static_cast<int>(random() % solid.particles.size());
        if (std::find(seeds.begin(), seeds.end(), s) == seeds.end()) seeds.push_back(s);
    }
    for (const Particle& p : solid.particles) {
        const auto distance = [&](int s) { return (solid.particles[s].position - p.position).squaredNorm(); };
        const auto nearest = std::min_element(seeds.begin(), seeds.end(),
                                              [&](int a, int b) { return distance(a) < distance(b); });
        labels.of_particle.push_back(static_cast<int>(nearest - seeds.begin()));
    }
    return labels;
}

}  // namespace sherd::fragment_support
