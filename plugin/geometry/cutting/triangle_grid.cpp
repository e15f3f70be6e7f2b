#include "geometry/cutting/triangle_grid.h"

#include <algorithm>
#include <cmath>

namespace sherd {

namespace {

constexpr double largest_cell_count = 2e6;

}  // namespace

template <class Visit>
void TriangleGrid::forEachCell(const Vec3& low, const Vec3& high, Visit visit) const {
    // Values are clamped to be positive, so that truncation rounds down.
    const Vec3 top = size_.cast<double>() - Vec3::Ones();
    const Eigen::Vector3i first = ((low - origin_) * cells_per_m_).cwiseMax(0).cwiseMin(top).cast<int>();
    const Eigen::Vector3i last = ((high - origin_) * cells_per_m_).cwiseMax(0).cwiseMin(top).cast<int>();
    for (int k = first.z(); k <= last.z(); ++k)
        for (int j = first.y(); j <= last.y(); ++j)
            for (int i = first.x(); i <= last.x(); ++i) visit(i + size_.x() * (j + size_.y() * k));
}

TriangleGrid::TriangleGrid(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
    if (triangles.empty()) return;
    double mean_edge = 0;
    for (const auto& [a, b, c] : triangles) {
        low_.push_back(points[a].cwiseMin(points[b]).cwiseMin(points[c]));
        high_.push_back(points[a].cwiseMax(points[b]).cwiseMax(points[c]));
        mean_edge += (high_.back() - low_.back()).maxCoeff() / static_cast<double>(triangles.size());
    }
    origin_ = low_.front();
    end_ = high_.front();
    for (const Vec3& p : low_) origin_ = origin_.cwiseMin(p);
    for (const Vec3& p : high_) end_ = end_.cwiseMax(p);
    const Vec3 extent = (end_ - origin_).array() + mean_edge;
    cells_per_m_ = 1 / std::max(mean_edge, std::cbrt(extent.prod() / largest_cell_count));
    size_ = (extent * cells_per_m_).array().ceil().cast<int>();
    first_.assign(size_.prod() + 1, 0);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        forEachCell(low_[t], high_[t], [&](int cell) { ++first_[cell + 1]; });
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    entries_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        forEachCell(low_[t], high_[t], [&](int cell) { entries_[next[cell]++] = static_cast<int>(t); });
}

void TriangleGrid::findNear(const Vec3& low, const Vec3& high, std::vector<int>& found) const {
    if (low_.empty() || (low.array() > end_.array()).any() || (high.array() < origin_.array()).any()) return;
    const auto begin = static_cast<long>(found.size());
    forEachCell(low, high, [&](int cell) {
        for (int e = first_[cell]; e < first_[cell + 1]; ++e) {
            const int t = entries_[e];
            if ((low_[t].array() <= high.array()).all() && (high_[t].array() >= low.array()).all())
                found.push_back(t);
        }
    });
    std::sort(found.begin() + begin, found.end());
    found.erase(std::unique(found.begin() + begin, found.end()), found.end());
}

}  // namespace sherd
