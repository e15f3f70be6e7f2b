#pragma once

#include <sherd/triangle_mesh.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace sherd_tests {

using sherd::TriangleMesh;
using sherd::Vec3;

constexpr double pi = 3.14159265358979323846;

/// A triangle of a crack, seen from one of its two pieces.
struct CrackFace {
    Vec3 centre = Vec3::Zero();  ///< m
    Vec3 area = Vec3::Zero();    ///< m^2, outward of the piece
};

inline std::vector<CrackFace> crackFaces(const TriangleMesh& piece) {
    std::vector<CrackFace> faces;
    for (std::size_t t = 0; t < piece.triangles.size(); ++t) {
        if (piece.kinds.empty() || piece.kinds[t] != sherd::SurfaceKind::crack) continue;
        const auto& [a, b, c] = piece.triangles[t];
        const Vec3 &p = piece.vertices[a], &q = piece.vertices[b], &r = piece.vertices[c];
        faces.push_back({(p + q + r) / 3, (q - p).cross(r - p) / 2});
    }
    return faces;
}

inline double volumeOf(const TriangleMesh& piece) {
    double volume = 0;
    const Vec3& from = piece.vertices.front();
    for (const auto& [a, b, c] : piece.triangles)
        volume +=
            (piece.vertices[a] - from).cross(piece.vertices[b] - from).dot(piece.vertices[c] - from) / 6;
    return volume;
}

/// Share of the crack area whose plane is within 20 degrees of the radial plane (which holds the axis of the
/// blow) or of the tangential one.
class AlignedShare {
  public:
    AlignedShare(const Vec3& contact, const Vec3& direction) : contact_(contact), direction_(direction) {}

    void add(const CrackFace& face) {
        Vec3 away = face.centre - contact_;
        away -= away.dot(direction_) * direction_;
        away.normalize();
        const double area = face.area.norm();
        const double along = std::abs(face.area.dot(away)),
                     around = std::abs(face.area.dot(direction_.cross(away)));
        all_ += area;
        if (std::max(along, around) > std::cos(20 * pi / 180) * area) aligned_ += area;
    }
    double value() const { return all_ > 0 ? aligned_ / all_ : 0; }

  private:
    Vec3 contact_, direction_;
    double aligned_ = 0, all_ = 0;
};

/// The least share of a piece's crack area that is in the way when the piece is moved along one direction, of
/// 2000, those that most faces lie along, and the one away from all together. A face is in the way if it
/// faces along the direction, by more than `tolerance_deg` from the plane across its normal.
inline double hookedShare(const std::vector<CrackFace>& faces, double tolerance_deg = 10) {
    const double least = std::sin(tolerance_deg * pi / 180);
    double all = 0;
    Vec3 sum_of_areas = Vec3::Zero();
    sherd::Mat3 facing = sherd::Mat3::Zero();
    for (const CrackFace& face : faces) {
        all += face.area.norm();
        sum_of_areas += face.area;
        if (face.area.norm() > 0) facing += face.area * face.area.transpose() / face.area.norm();
    }
    const auto inTheWay = [&](const Vec3& direction) {
        double sum = 0;
        for (const CrackFace& face : faces)
            if (face.area.dot(direction) > least * face.area.norm()) sum += face.area.norm();
        return sum;
    };
    const Eigen::SelfAdjointEigenSolver<sherd::Mat3> solver(facing);
    double best = inTheWay(-sum_of_areas.normalized());
    for (int d = 0; d < 3; ++d)
        for (const int sign : {-1, 1}) best = std::min(best, inTheWay(sign * solver.eigenvectors().col(d)));
    constexpr int directions = 2000;
    for (int k = 0; k < directions; ++k) {
        const double z = 1 - (2 * k + 1.0) / directions, r = std::sqrt(1 - z * z),
                     angle = k * pi * (3 - std::sqrt(5.0));
        best = std::min(best, inTheWay(Vec3(r * std::cos(angle), r * std::sin(angle), z)));
    }
    return all > 0 ? best / all : 0;
}

/// How flat the cracks between pairs of pieces are, weighted with their area: 1 for planes. Both sides of a
/// crack have the same triangles, so pairs are found by their centres.
inline double flatness(const std::vector<TriangleMesh>& pieces) {
    std::map<std::array<double, 3>, int> first_piece;
    std::map<std::pair<int, int>, std::pair<Vec3, double>> contacts;
    for (int p = 0; p < static_cast<int>(pieces.size()); ++p)
        for (const CrackFace& face : crackFaces(pieces[p])) {
            std::array<double, 3> key{};
            for (int d = 0; d < 3; ++d) key[d] = std::round(face.centre[d] * 1e9);
            const auto [entry, is_new] = first_piece.insert({key, p});
            if (is_new) continue;
            auto& [sum, area] = contacts.insert({{entry->second, p}, {Vec3::Zero(), 0.0}}).first->second;
            sum += face.area;
            area += face.area.norm();
        }
    double flat = 0, all = 0;
    for (const auto& [pair, contact] : contacts) {
        flat += contact.first.norm();
        all += contact.second;
    }
    return all > 0 ? flat / all : 1;
}

/// Logarithms of the likelihood of sizes under two laws, a size: a power law between the smallest and the
/// largest, its exponent fitted, and a gamma law with one peak (shape at least 1; 1 is the exponential one),
/// fitted too.
struct SizeLaws {
    double power_law = 0, one_size = 0;
    double exponent = 0;     ///< of the density, size^-exponent
    double decades = 0;      ///< between the 2nd and the 98th percentile
    double all_decades = 0;  ///< between the smallest and the largest: what the power law is fitted to
};

inline SizeLaws sizeLaws(std::vector<double> sizes) {
    SizeLaws laws;
    std::sort(sizes.begin(), sizes.end());
    const double n = static_cast<double>(sizes.size()), low = sizes.front(), high = sizes.back();
    double log_mean = 0, mean = 0;
    for (const double size : sizes) log_mean += std::log(size) / n, mean += size / n;
    laws.decades = std::log10(sizes[static_cast<std::size_t>(0.98 * (n - 1))] /
                              sizes[static_cast<std::size_t>(0.02 * (n - 1))]);
    laws.all_decades = std::log10(high / low);
    laws.power_law = laws.one_size = -std::numeric_limits<double>::infinity();
    for (double a = -1; a < 4; a += 0.01) {
        const double area = std::abs(a - 1) < 1e-9 ? std::log(high / low)
                                                   : (std::pow(high, 1 - a) - std::pow(low, 1 - a)) / (1 - a);
        const double likelihood = -a * log_mean - std::log(area);
        if (likelihood > laws.power_law) laws.power_law = likelihood, laws.exponent = a;
    }
    for (double k = 1; k < 20; k *= 1.02)
        laws.one_size =
            std::max(laws.one_size, (k - 1) * log_mean - k - std::lgamma(k) - k * std::log(mean / k));
    return laws;
}

}  // namespace sherd_tests
