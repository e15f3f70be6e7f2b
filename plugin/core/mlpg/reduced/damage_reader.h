#pragma once

#include <vector>

#include "core/damage/damage.h"
#include "core/damage/equivalent_bound.h"
#include "core/mlpg/reduced/contact_reading.h"
#include "core/mlpg/reduced/gradient_lanes.h"
#include "core/mlpg/reduced/stress_bounds.h"
#include "core/mlpg/splines/reading_points.h"
#include "core/mlpg/splines/spline_problem.h"
#include "core/stress/stress_lanes.h"

namespace sherd {

/// What a reader reads of. What it refers to outlives the reader.
struct DamageSource {
    const SplineProblem& problem;
    const ReadingPoints& points;
    const StressBounds& bounds;
    const Eigen::MatrixXf& powers;  ///< of the pieces of the splines
};

/// A displacement as the parts see it.
struct PartDisplacement {
    Eigen::Matrix4Xf raw;        ///< coefficients of all functions
    Eigen::MatrixXf dilatation;  ///< projected, or empty
};

/// Reads the stress of one displacement, part by part, and keeps what is nearer to failure than what was read
/// before. Points wait until there are as many as lanes; `finish` reads the last ones. `displacement`,
/// `contact` and `strength` outlive it.
class DamageReader {
  public:
    /// `scale` multiplies displacement and contact.
    DamageReader(const DamageSource& source, const PartDisplacement& displacement,
                 const ContactReading& contact, double scale, const Strength& strength, const Damage& before);

    /// Whether an overstress in a part of up to `bound` may be one that matters.
    bool mayFindMore(int part, double bound, double wanted) const;
    /// Reads the points of a part that may be as near to failure as the overstress `wanted`, or under the
    /// largest tension.
    void read(int part, double wanted);
    /// Reads the stress at the places of the contact, which are none of the points.
    void readPlaces();
    /// Reads what waits.
    void finish();

    /// The stress that is nearest to failure at a particle, so far.
    struct Found {
        int particle;
        double overstress;
        SymmetricTensor stress;  ///< Pa
    };
    const std::vector<Found>& found() const { return found_; }
    double tension() const { return tension_; }

  private:
    /// Where the stress is read. `normal`: of the surface there, or zero; `point`: whose strength and
    /// particle count there; `unresolved`: see SurfacePlace.
    struct Spot {
        Vec3 x;
        Eigen::Vector3f normal;
        int point;
        double wanted;
        SymmetricTensor unresolved;
    };

    struct Waiting {
        int count = 0;
        PlaceLanes at = {};
        StressLanes unresolved = {};
        PlaceLanes::Lane gradient[3][3] = {};
        SurfaceLanes surface = {};
        int point[PlaceLanes::count];
        double wanted[PlaceLanes::count];
    };

    void takeCoefficients(int part);
    void setPoint(int lane, const Eigen::Vector3f& xi);
    /// Displacement gradients with the dilatation that the stiffness sees.
    void readGradients(int part, int count);
    /// `lane`: of the gradients.
    void wait(int lane, const Spot& spot);
    void include(const SymmetricTensor& stress, int point);
    double leastThatMatters(int particle, double wanted) const;
    /// `smallest_pa`, `largest_pa`: no principal stress is beyond these.
    bool doesNotMatter(double smallest_pa, double largest_pa, double wanted, int point) const;

    DamageSource source_;
    const PartDisplacement& displacement_;
    float projected_share_;
    const ContactReading& contact_;
    double scale_;
    const Strength& strength_;
    EquivalentBound bound_;
    Eigen::Vector3f per_edge_;  ///< of a cell
    PartCoefficients coefficients_;
    GradientLanes gradients_ = {};
    Waiting waiting_;
    std::vector<double> overstress_;  ///< per particle, the largest that was read
    std::vector<Found> found_;        ///< of a particle each time nearer to failure
    double tension_;                  ///< the largest that was read, Pa, for a scale of 1
};

}  // namespace sherd
