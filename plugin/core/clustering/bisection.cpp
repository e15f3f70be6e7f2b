#include "core/clustering/bisection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include "core/clustering/best_cut.h"
#include "core/clustering/connected_pieces.h"
#include "core/clustering/crack_tree.h"
#include "core/clustering/damaged_region.h"
#include "core/clustering/tension_metric.h"
#include "core/clustering/way_out.h"
#include "core/numerics/union_find.h"

namespace sherd {

namespace {

constexpr std::size_t most_samples = 160;  // of a part, that choose its plane
constexpr double too_little = 0.5;  // pieces; what a cut leaves unconnected joins a neighbour below that
constexpr int attempts = 3;         // to find a plane that leaves parts that can be moved out

/// A connected part of the body.
struct Cell {
    std::vector<int> members;        // ascending
    std::vector<int> borders;        // between these; ascending
    std::vector<CrackPlane> bounds;  // cracks that it reaches, their normals outward
    double pieces = 0;               // that it is to become; 0 once it is not to be cut
    int part = -1;                   // of the tree
    bool stray = false;
    bool around_hole = false;
};

class Bisection {
  public:
    Bisection(const Discretisation& solid, const std::vector<Vec3>& axes,
              const std::vector<TensionMetric>& metrics, const std::vector<char>& holds, double affordable_m2,
              std::uint64_t seed)
        : solid_(solid),
          axes_(axes),
          metrics_(metrics),
          seed_(seed),
          affordable_m2_(affordable_m2),
          connected_(solid),
          cell_of_(solid.particles.size(), -1) {
        if (std::isfinite(affordable_m2))
            for (const IntegrationFace& face : solid.faces) {
                const int a = solid.cells[face.cells[0]].particle, b = solid.cells[face.cells[1]].particle;
                if (a != b) borders_.push_back({a, b, face.area});
            }
        for (const bool held : {false, true}) {
            std::vector<int> all;
            for (std::size_t i = 0; i < solid.particles.size(); ++i)
                if ((!holds.empty() && holds[i]) == held) all.push_back(static_cast<int>(i));
            if (all.empty()) continue;
            if (!cells_.empty()) tree_->letRootsTouch();
            for (auto& members : connected_.of(all)) {
                addCell(std::move(members), tree_->addRoot());
                if (held) cells_.back().pieces = 0;
            }
        }
        std::vector<int> borders(borders_.size());
        std::iota(borders.begin(), borders.end(), 0);
        giveToCells(borders);
    }

    /// Cuts along the planes of a hole; what is outside is one piece, whatever plane it lies behind.
    void cutOut(const std::vector<CrackPlane>& hole) {
        for (const CrackPlane& plane : hole) {
            // The first cells are cut first, and what is cut out of them comes last.
            const int before = static_cast<int>(cells_.size());
            for (int which = before - 1; which >= 0; --which) {
                if (cells_[which].around_hole) continue;
                Sides sides = sidesOf(cells_[which], plane);
                if (sides[0].members.empty() || sides[1].members.empty()) continue;
                const std::vector<int> outside = sides[1].members;
                affordable_m2_ -= crackArea(which, plane);
                replace(which, plane, std::move(sides));
                for (const int i : outside) {
                    cells_[cell_of_[i]].around_hole = true;
                    cells_[cell_of_[i]].pieces = 0;
                }
            }
        }
    }

    void run(int pieces) {
        const auto around =
            std::count_if(cells_.begin(), cells_.end(), [](const Cell& cell) { return cell.around_hole; });
        if (around > 0) pieces += static_cast<int>(around) - 1;
        while (static_cast<int>(cells_.size()) - strays_ < pieces) {
            const auto next =
                std::max_element(cells_.begin(), cells_.end(),
                                 [](const Cell& a, const Cell& b) { return a.pieces < b.pieces; });
            if (!(next->pieces > 0)) break;
            split(static_cast<int>(next - cells_.begin()));
        }
    }

    void label(FragmentLabels& labels) const {
        UnionFind merged(cells_.size());
        joinAroundHole(merged);
        joinStrays(merged);
        std::vector<int> number(cells_.size(), -1);
        for (std::size_t c = 0; c < cells_.size(); ++c)
            if (merged.isRoot(static_cast<int>(c))) number[c] = labels.count++;
        labels.cracks = tree_;
        labels.part.resize(cell_of_.size());
        for (std::size_t i = 0; i < cell_of_.size(); ++i) {
            labels.of_particle[i] = number[merged.root(cell_of_[i])];
            labels.part[i] = cells_[cell_of_[i]].part;
        }
    }

  private:
    void addCell(std::vector<int> members, int part, std::vector<CrackPlane> bounds = {},
                 bool may_be_stray = false) {
        Cell cell;
        cell.members = std::move(members);
        cell.bounds = std::move(bounds);
        cell.part = part;
        cell.pieces = piecesOf(cell.members);
        for (const int i : cell.members) cell_of_[i] = static_cast<int>(cells_.size());
        cell.stray = may_be_stray && cell.pieces < too_little;
        if (cell.stray) cell.pieces = 0, ++strays_;
        cells_.push_back(std::move(cell));
    }

    /// Those within a cell, to that cell; what joins two is cut already.
    void giveToCells(const std::vector<int>& borders) {
        for (const int border : borders) {
            const int cell = cell_of_[borders_[border].a];
            if (cell_of_[borders_[border].b] == cell) cells_[cell].borders.push_back(border);
        }
    }

    /// What a plane leaves of a cell at negative and at positive distances.
    struct Side {
        std::vector<int> members;
        std::vector<CrackPlane> bounds;
    };
    using Sides = std::array<Side, 2>;

    Sides sidesOf(const Cell& cell, const CrackPlane& plane) const {
        Sides sides;
        for (const int i : cell.members)
            sides[plane.distance(solid_.particles[i].position) > 0].members.push_back(i);
        for (const int side : {0, 1}) {
            std::vector<CrackPlane> bounds = cell.bounds;
            bounds.push_back(side == 0 ? plane : CrackPlane{-plane.normal, -plane.offset_m});
            for (const CrackPlane& bound : bounds)
                if (std::any_of(sides[side].members.begin(), sides[side].members.end(), [&](int i) {
                        return bound.distance(solid_.particles[i].position) > -solid_.spacing;
                    }))
                    sides[side].bounds.push_back(bound);
        }
        return sides;
    }

    static bool isPossible(const Side& side) {
        std::vector<Vec3> normals;
        for (const CrackPlane& bound : side.bounds) normals.push_back(bound.normal);
        return !side.members.empty() && hasWayOut(normals);
    }

    /// Of the section of a plane through a cell, m^2.
    double crackArea(int which, const CrackPlane& plane) const {
        double sum = 0;
        for (const int border : cells_[which].borders) {
            const auto& [a, b, area] = borders_[border];
            const bool above_a = plane.distance(solid_.particles[a].position) > 0,
                       above_b = plane.distance(solid_.particles[b].position) > 0;
            if (above_a != above_b) sum += (above_b ? 1 : -1) * area.dot(plane.normal);
        }
        return std::abs(sum);
    }

    /// Cuts a cell, or notes that it is not to be cut.
    void split(int which) {
        for (int attempt = 0; attempt < attempts; ++attempt) {
            const auto counter = static_cast<std::uint64_t>(cells_[which].part * attempts + attempt);
            const auto plane = bestCut(samplesOf(cells_[which]), solid_.spacing, seed_, counter);
            if (!plane) break;
            Sides sides = sidesOf(cells_[which], *plane);
            if (!isPossible(sides[0]) || !isPossible(sides[1])) continue;
            const double area_m2 = crackArea(which, *plane);
            if (area_m2 > affordable_m2_) continue;
            affordable_m2_ -= area_m2;
            return replace(which, *plane, std::move(sides));
        }
        cells_[which].pieces = 0;
    }

    void replace(int which, const CrackPlane& plane, Sides sides) {
        const int first = tree_->cut(cells_[which].part, plane);
        const std::vector<int> borders = std::move(cells_[which].borders);
        std::swap(cells_[which], cells_.back());
        cells_.pop_back();
        if (which < static_cast<int>(cells_.size()))
            for (const int i : cells_[which].members) cell_of_[i] = which;
        for (const int side : {0, 1}) {
            auto parts = connected_.of(sides[side].members);
            for (std::size_t p = 0; p < parts.size(); ++p)
                addCell(std::move(parts[p]), parts.size() > 1 ? tree_->addPiece(first + side) : first + side,
                        sides[side].bounds, p > 0);
        }
        giveToCells(borders);
    }

    double piecesOf(const std::vector<int>& members) const {
        double pieces = 0;
        for (const int i : members) pieces += metrics_[i].pieces;
        return pieces;
    }

    /// Evenly of volume and of pieces.
    std::vector<CutSample> samplesOf(const Cell& cell) const {
        double volume = 0;
        for (const int i : cell.members) volume += solid_.particles[i].volume;
        const auto chance = [&](int i) {
            return most_samples * 0.5 *
                   (solid_.particles[i].volume / volume + metrics_[i].pieces / cell.pieces);
        };
        std::vector<CutSample> samples;
        double due = 0.5;
        for (const int i : cell.members) {
            const double p = cell.members.size() > most_samples ? std::min(1.0, chance(i)) : 1;
            due += p;
            if (due < 1) continue;
            due -= 1;
            const Particle& particle = solid_.particles[i];
            const TensionMetric& metric = metrics_[i];
            samples.push_back(
                {particle.position, axes_[i], metric.tensor, particle.volume / p, metric.pieces / p});
        }
        return samples;
    }

    void joinAroundHole(UnionFind& merged) const {
        int first = -1;
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            if (!cells_[c].around_hole) continue;
            if (first < 0)
                first = static_cast<int>(c);
            else
                merged.uniteInto(first, static_cast<int>(c));
        }
    }

    void joinStrays(UnionFind& merged) const {
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            if (!cells_[c].stray) continue;
            std::map<int, int> borders;
            for (const int i : cells_[c].members)
                for (const int j : solid_.neighbours[i])
                    if (merged.root(cell_of_[j]) != merged.root(static_cast<int>(c)))
                        ++borders[merged.root(cell_of_[j])];
            const auto longest =
                std::max_element(borders.begin(), borders.end(),
                                 [](const auto& a, const auto& b) { return a.second < b.second; });
            if (longest != borders.end()) merged.uniteInto(longest->first, merged.root(static_cast<int>(c)));
        }
    }

    const Discretisation& solid_;
    const std::vector<Vec3>& axes_;
    const std::vector<TensionMetric>& metrics_;  // #particles
    std::uint64_t seed_;
    double affordable_m2_;  // of what is left to be cut
    /// A face between two particles, its area from the one to the other.
    struct Border {
        int a, b;
        Vec3 area;
    };
    std::vector<Border> borders_;  // none where any crack can be paid for
    ConnectedPieces connected_;
    std::vector<int> cell_of_;  // #particles
    std::vector<Cell> cells_;
    std::shared_ptr<CrackTree> tree_ = std::make_shared<CrackTree>();
    int strays_ = 0;
};

}  // namespace

FragmentLabels bisectParticles(const Discretisation& solid, const std::vector<Vec3>& axes,
                               const Damage& damage, int clusters, int most_pieces, double wall_thickness_m,
                               std::uint64_t seed, const std::vector<char>& holds,
                               const std::vector<CrackPlane>& hole, const GuideField& guide,
                               const BlowAxis& blow, double affordable_m2) {
    const Damage region = damagedRegion(solid, axes, damage, wall_thickness_m);
    FragmentLabels labels;
    if (labelWholeParts(solid, region.damaged, labels).empty()) return labels;
    int parted = labels.count;
    if (clusters + parted < most_pieces)
        parted = std::max(parted, partedOnTheWay(solid, axes, damage, wall_thickness_m));
    const int pieces = std::min(clusters + parted, most_pieces);
    labels.count = 0;
    const auto metrics = tensionMetrics(solid, axes, region, pieces, wall_thickness_m, guide, blow);
    Bisection bisection(solid, axes, metrics, holds, affordable_m2, seed);
    bisection.cutOut(hole);
    bisection.run(pieces);
    bisection.label(labels);
    return labels;
}

}  // namespace sherd
