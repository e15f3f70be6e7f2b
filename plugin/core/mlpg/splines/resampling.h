#pragma once

#include "core/mlpg/splines/high_stress.h"
#include "core/mlpg/splines/kept_zooms.h"
#include "core/mlpg/splines/load_boxes.h"
#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

/// Finer and finer grids where a solved displacement needs them (paper, section 5): around loads, and on the
/// surface where the stress is high and not known well.
class Resampling {
  public:
    /// `largest_entries`: about as many numbers may be stored for the grids at high stress, for one set of
    /// loads.
    Resampling(const SplineProblem& problem, ResamplingReach reach, long long largest_entries);

    /// Coarser grids first. `whole` is the displacement under `loads` on the problem's own grid.
    Result<std::vector<Zoom>> resample(const SplineProblem& problem, const SplineField& whole,
                                       const BodyLoads& loads) const;

  private:
    struct Place;
    struct Spot;
    std::vector<Spot> spotsOn(const SplineProblem& problem, const std::vector<Place>& places,
                              const std::vector<Zoom>& around_loads, double peak_pa) const;
    Result<std::vector<Place>> atHighStress(const SplineProblem& problem, const std::vector<Place>& coarser,
                                            const std::vector<Zoom>& around_loads, double peak_pa,
                                            long long& entries) const;

    ResamplingReach reach_;
    long long largest_entries_;
    std::vector<SurfaceSample> samples_;
    std::shared_ptr<KeptZooms> kept_;
};

}  // namespace sherd
