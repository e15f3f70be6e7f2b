#pragma once

#include <gtest/gtest.h>

#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace sherd {

/// Volume, centroid and second moment of a closed surface, tetrahedron by tetrahedron from an inner point.
inline Moments meshMoments(const TriangleMesh& mesh) {
    Vec3 reference = Vec3::Zero();
    for (const Vec3& v : mesh.vertices) reference += v / double(mesh.vertices.size());
    double volume = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
    for (const auto& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[0]] - reference, b = mesh.vertices[t[1]] - reference,
                   c = mesh.vertices[t[2]] - reference, sum = a + b + c;
        const double v = a.dot(b.cross(c)) / 6;
        volume += v;
        first += v * sum / 4;
        second +=
            v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    }
    const Vec3 c = first / volume;
    return {volume, reference + c, second - volume * c * c.transpose()};
}

inline Discretisation sampled(const TriangleMesh& mesh, double spacing, int cells_per_spacing = 2) {
    SamplingSettings settings;
    settings.cells_per_spacing = cells_per_spacing;
    Result<Discretisation> result = sampleSolid(mesh, spacing, settings);
    EXPECT_TRUE(result.ok()) << result.error();
    return result.ok() ? std::move(result).value() : Discretisation{};
}

/// Compensated (Kahan) sum: many cells are equal, and the rounding of equal terms adds up instead of
/// cancelling.
template <class Value>
class Sum {
  public:
    explicit Sum(const Value& zero) : total_(zero), lost_(zero) {}
    void add(const Value& term) {
        const Value corrected = term - lost_;
        const Value next = total_ + corrected;
        lost_ = (next - total_) - corrected;
        total_ = next;
    }
    const Value& total() const { return total_; }

  private:
    Value total_, lost_;
};

/// Of the whole solid, summed over its cells.
inline Moments totalMoments(const Discretisation& solid) {
    // About the first cell: far from the origin nothing is lost.
    const Vec3 reference = solid.cells.empty() ? Vec3(Vec3::Zero()) : solid.cells.front().moments.centroid;
    Sum<double> volume(0);
    Sum<Vec3> first(Vec3::Zero());
    for (const IntegrationCell& cell : solid.cells) {
        volume.add(cell.moments.volume);
        first.add(cell.moments.volume * (cell.moments.centroid - reference));
    }
    Moments total;
    total.volume = volume.total();
    if (total.volume <= 0) return total;
    total.centroid = reference + first.total() / total.volume;
    Sum<Mat3> second(Mat3::Zero());
    for (const IntegrationCell& cell : solid.cells) {
        const Vec3 d = cell.moments.centroid - total.centroid;
        second.add(cell.moments.second + cell.moments.volume * d * d.transpose());
    }
    total.second = second.total();
    return total;
}

/// The sampled solid has the moments of its surface.
inline void expectMoments(const Discretisation& solid, const TriangleMesh& mesh, double tolerance = 1e-12) {
    const Moments expected = meshMoments(mesh), found = totalMoments(solid);
    const double length = std::sqrt(expected.second.trace() / expected.volume);
    EXPECT_NEAR(found.volume / expected.volume, 1, tolerance);
    EXPECT_LT((found.centroid - expected.centroid).norm(), tolerance * length);
    EXPECT_LT((found.second - expected.second).norm(), tolerance * expected.second.norm());
}

/// Largest violation, over all cells, of sum area = 0 and of sum area (x) centroid = volume I, relative to a
/// voxel.
inline std::pair<double, double> closingErrors(const Discretisation& solid) {
    const std::size_t count = solid.cells.size();
    std::vector<Vec3> area(count, Vec3::Zero());
    std::vector<Mat3> moment(count, Mat3::Zero());
    const auto add = [&](int cell, const Vec3& weight, const Vec3& x) {
        area[cell] += weight;
        moment[cell] += (x - solid.cells[cell].moments.centroid) * weight.transpose();
    };
    for (const IntegrationFace& face : solid.faces) {
        add(face.cells[0], face.area, face.centroid);
        add(face.cells[1], -face.area, face.centroid);
    }
    for (const SurfacePoint& point : solid.surface_points) add(point.cell, point.area, point.position);
    const double edge = solid.cell_size.maxCoeff();
    double worst_area = 0, worst_moment = 0;
    for (std::size_t c = 0; c < count; ++c) {
        worst_area = std::max(worst_area, area[c].norm() / (edge * edge));
        worst_moment =
            std::max(worst_moment, (moment[c] - solid.cells[c].moments.volume * Mat3::Identity()).norm() /
                                       (edge * edge * edge));
    }
    return {worst_area, worst_moment};
}

/// Every cell closes, has volume and a particle; particles and cells and neighbours name each other.
inline void expectSound(const Discretisation& solid, double tolerance = 1e-12) {
    const auto [area, moment] = closingErrors(solid);
    EXPECT_LT(area, tolerance);
    EXPECT_LT(moment, tolerance);
    ASSERT_EQ(solid.neighbours.size(), solid.particles.size());
    ASSERT_EQ(solid.particle_cells.size(), solid.particles.size());
    std::vector<double> volume(solid.particles.size(), 0.0);
    for (const IntegrationCell& cell : solid.cells) {
        EXPECT_GT(cell.moments.volume, 0);
        EXPECT_GT(cell.moments.second.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0);
        volume.at(cell.particle) += cell.moments.volume;
    }
    for (std::size_t p = 0; p < solid.particles.size(); ++p) {
        EXPECT_NEAR(volume[p], solid.particles[p].volume, 1e-12 * volume[p]);
        double of_cells = 0;
        for (const int c : solid.particle_cells[p]) {
            EXPECT_EQ(solid.cells.at(c).particle, int(p));
            of_cells += solid.cells[c].moments.volume;
        }
        EXPECT_NEAR(of_cells, volume[p], 1e-12 * volume[p]);
        EXPECT_TRUE(std::is_sorted(solid.neighbours[p].begin(), solid.neighbours[p].end()));
        for (const int q : solid.neighbours[p]) {
            EXPECT_NE(q, int(p));
            const auto& back = solid.neighbours.at(q);
            EXPECT_TRUE(std::binary_search(back.begin(), back.end(), int(p)));
        }
    }
}

/// How many separate bodies the neighbour table makes.
inline int connectedBodies(const Discretisation& solid) {
    std::vector<char> seen(solid.particles.size(), 0);
    int bodies = 0;
    for (std::size_t start = 0; start < seen.size(); ++start) {
        if (seen[start]) continue;
        ++bodies;
        std::vector<int> open = {int(start)};
        seen[start] = 1;
        while (!open.empty()) {
            const int p = open.back();
            open.pop_back();
            for (const int q : solid.neighbours[p])
                if (!seen[q]) seen[q] = 1, open.push_back(q);
        }
    }
    return bodies;
}

}  // namespace sherd
