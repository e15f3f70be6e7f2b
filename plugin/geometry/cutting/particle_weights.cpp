#include "geometry/cutting/particle_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sherd {

namespace {

// Density of the own label over the next one that a particle should have; beside a flat crack it is about 2.
constexpr double winning_ratio = 1.5;
constexpr double largest_raise = 30;
constexpr double most_at_once = 3;
constexpr int raising_rounds = 8;

/// Sums by label.
class LabelSums {
  public:
    explicit LabelSums(int label_count) : sums_(label_count), is_met_(label_count, false) {}

    void clear() {
        for (const int label : met_) is_met_[label] = false;
        met_.clear();
    }
    void add(int label, double value) {
        if (is_met_[label]) {
            sums_[label] += value;
            return;
        }
        sums_[label] = value;
        is_met_[label] = true;
        met_.push_back(label);
    }
    /// The sum of a label over the largest of the others.
    double ownOverNext(int own) const {
        double next = 0;
        for (const int label : met_)
            if (label != own) next = std::max(next, sums_[label]);
        return next > 0 ? (is_met_[own] ? sums_[own] : 0) / next : std::numeric_limits<double>::infinity();
    }

  private:
    std::vector<double> sums_;  // #labels
    std::vector<char> is_met_;
    std::vector<int> met_;
};

class Raising {
  public:
    Raising(const Discretisation& solid, const ParticleReach& reach, const FragmentLabels& labels)
        : reach_(reach), labels_(labels), sums_(labels.count) {
        for (const Particle& particle : solid.particles)
            fill_.push_back(particle.volume / std::pow(kernelRadius(particle), 3));
        weights_ = fill_;
    }

    std::vector<double> run() {
        std::vector<int> contested;  // those with another label in reach, which the weights do not change
        for (int i = 0; i < static_cast<int>(fill_.size()); ++i)
            if (isContested(i)) contested.push_back(i);
        for (int round = 0; round < raising_rounds; ++round) {
            bool raised = false;
            for (const int i : contested) raised |= raise(i);
            if (!raised) break;
        }
        return std::move(weights_);
    }

  private:
    bool isContested(int particle) const {
        const int own = labels_.of_particle[particle];
        for (std::size_t k = reach_.first[particle]; k < reach_.first[particle + 1]; ++k) {
            const int other = reach_.all[k].particle;
            if (labels_.of_particle[other] != own) return true;
            const RunnerUp runner_up = labels_.runnerUpOf(other);
            if (runner_up.share > 0 && runner_up.label != own) return true;
        }
        return false;
    }

    // The density of a particle's own label at its position over that of the next one.
    double ownOverNext(int particle) {
        sums_.clear();
        for (std::size_t k = reach_.first[particle]; k < reach_.first[particle + 1]; ++k) {
            const ParticleReach::Contribution& c = reach_.all[k];
            const RunnerUp runner_up = labels_.runnerUpOf(c.particle);
            const double value = weights_[c.particle] * c.kernel;
            sums_.add(labels_.of_particle[c.particle], (1 - runner_up.share) * value);
            if (runner_up.share > 0) sums_.add(runner_up.label, runner_up.share * value);
        }
        return sums_.ownOverNext(labels_.of_particle[particle]);
    }

    bool raise(int i) {
        const double ratio = ownOverNext(i);
        // Right beside a crack a particle has no more than its own share of what is there.
        const double share = labels_.runnerUpOf(i).share;
        const double wanted = share > 0 ? std::min(winning_ratio, (1 - share) / share) : winning_ratio;
        if (ratio >= wanted || weights_[i] >= largest_raise * fill_[i]) return false;
        const double raise = ratio > 0 ? std::min(most_at_once, wanted / ratio * 1.1) : most_at_once;
        weights_[i] = std::min(largest_raise * fill_[i], raise * weights_[i]);
        return true;
    }

    const ParticleReach& reach_;
    const FragmentLabels& labels_;
    LabelSums sums_;
    std::vector<double> fill_, weights_;
};

}  // namespace

std::vector<double> particleWeights(const Discretisation& solid, const ParticleReach& reach,
                                    const FragmentLabels& labels) {
    return Raising(solid, reach, labels).run();
}

}  // namespace sherd
