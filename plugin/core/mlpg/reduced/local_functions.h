#pragma once

#include <vector>

#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

/// Which functions reach which parts of a solid, and through them, what is near a load.
class LocalFunctions {
  public:
    explicit LocalFunctions(const SplineProblem& problem);

    /// The functions that reach the parts under the loads and through the solid, ascending: about `most` of
    /// them, those under the largest loads first; and of the parts around these, until they are half as many.
    /// Twice as many around them change the largest stress by 0.1 % at most in the median of 60 blows on each
    /// of five bodies, and by 1.1 % in the highest tenth. Faint loads have none.
    std::vector<int> around(const std::vector<PointForce>& loads, int most) const;

  private:
    /// What acts on a part.
    struct Push {
        Vec3 place = Vec3::Zero();  ///< times `size`
        Vec3 force = Vec3::Zero();
        double size = 0;
    };
    void addThrough(const Push& push, std::vector<int>& parts) const;
    void addDiagonal(int part, std::vector<int>& parts) const;

    const CellParts& parts_;
    int function_count_;
    std::vector<int> starts_, of_part_;  ///< the functions of each part
};

}  // namespace sherd
