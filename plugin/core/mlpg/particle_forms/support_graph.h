#pragma once

#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Which particles may see each other: only through the solid. A particle's support ball may cross a gap;
/// what counts is the part of the ball that is connected, along neighbouring sub-domains inside the ball, to
/// the point looked at.
class SupportGraph {
  public:
    /// `support_radius` in particle spacings. `solid` must outlive this object.
    SupportGraph(const Discretisation& solid, double support_radius);

    /// Particles whose support may reach a point of `owner`'s sub-domain; sorted, contains `owner`.
    const std::vector<int>& candidates(int owner) const { return candidates_[owner]; }

    /// The same with all supports `factor` times as wide.
    std::vector<int> widerCandidates(int owner, double factor) const;

    /// Per particle: those whose sub-domain may come nearer to it than `radius` of its spacings; sorted,
    /// itself included.
    std::vector<std::vector<int>> balls(double radius) const;

    double supportRadius(int particle) const { return support_radius_ * solid_->particles[particle].spacing; }

    /// Distance from a particle to the farthest known point of its sub-domain, m.
    double extent(int particle) const { return extents_[particle]; }

  private:
    const Discretisation* solid_;
    double support_radius_;
    std::vector<double> extents_;               // #particles
    std::vector<std::vector<int>> candidates_;  // #particles
};

/// Connected component of every particle in the graph of neighbours, numbered by first particle.
struct Components {
    std::vector<int> of_particle;
    int count = 0;
};
Components connectedComponents(const Discretisation& solid);

}  // namespace sherd
