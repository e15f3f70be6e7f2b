#pragma once

#include <vector>

#include "core/mlpg/splines/reading_points.h"
#include "core/mlpg/splines/spline_problem.h"
#include "core/stress/loaded_places.h"
#include "core/stress/near_field.h"

namespace sherd {

/// What reading the stress takes from the contacts of a blow. It is found once, and serves all moments of the
/// blow, which threads may read side by side. Forces are those of the contact field that it was made from.
class ContactReading {
  public:
    /// A place of the contact field that lies in the solid.
    struct Place {
        Vec3 position = Vec3::Zero();                      ///< m
        Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< outward, unit
        GridPoint where;
        int nearest = 0;                                       ///< reading point, whose strength counts there
        SymmetricTensor unresolved = SymmetricTensor::Zero();  ///< see SurfacePlace
    };

    ContactReading(const SplineProblem& problem, const ReadingPoints& points, const ContactField& contact);

    bool hasNearField() const { return !near_.empty(); }
    /// By their parts.
    const std::vector<Place>& places() const { return places_; }

    /// No principal stress of the near field in a part is larger, Pa.
    double nearBound(int part) const { return near_bounds_[part]; }
    void addNearStress(const PlaceLanes& at, StressLanes& sum) const { near_.addStressAt(at, sum); }
    /// What the near field's discs do to the surface at x, Pa.
    Vec3 tractionAt(const Vec3& x, const Vec3& outward) const { return near_.tractionAt(x, outward); }
    /// Near loads that no disc stands for.
    bool isLoaded(const Vec3& x) const { return loaded_.isNear(x); }

  private:
    NearField near_;
    LoadedPlaces loaded_;
    std::vector<Place> places_;
    std::vector<double> near_bounds_;  ///< per part; empty without a near field
};

}  // namespace sherd
