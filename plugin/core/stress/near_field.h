#pragma once

#include <functional>
#include <vector>

#include "core/stress/contact_disc.h"

namespace sherd {

/// Numbers by threes, each coordinate by itself.
using RowsOf3 = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Pieces of a surface: their middles, m, and their area vectors, m^2, outward.
struct SurfacePieces {
    RowsOf3 places, areas;
};

/// The stress that contacts make in half-spaces, one for each disc, all of them together. Around a contact it
/// is most of the stress of a body, and all of it that a grid is too coarse for: what is left changes slowly.
class NearField {
  public:
    NearField() = default;
    NearField(const std::vector<ContactDisc>& discs, double poisson_ratio);

    bool empty() const { return discs_.empty(); }
    const std::vector<ContactDisc>& discs() const { return discs_; }
    /// The share of a place of the surface that belongs to small pieces about that disc, see ContactField.
    double closeShare(const Vec3& x, std::size_t disc) const;
    /// That of all discs together.
    double closeShare(const Vec3& x) const;

    Mat3 stressAt(const Vec3& x) const;  ///< Pa
    /// Adds the same, but for the last digits, at several places.
    void addStressAt(const PlaceLanes& at, StressLanes& sum) const;
    /// Calls visit(i, stress in Pa) for i from 0 to count - 1, at place(i). Both may be called on several
    /// threads at once.
    void visitStress(Eigen::Index count, const std::function<Vec3(Eigen::Index)>& place,
                     const std::function<void(Eigen::Index, const SymmetricTensor&)>& visit) const;
    /// The stress times the area vectors, N.
    RowsOf3 forcesOn(const SurfacePieces& pieces) const;
    /// What acts on the surface at x, Pa: the discs whose plane it lies on, or nearly so. `outward`: its
    /// normal.
    Vec3 tractionAt(const Vec3& x, const Vec3& outward) const;
    /// No principal stress within `radius` of x is larger, Pa.
    double largestAbout(const Vec3& x, double radius) const;

  private:
    std::vector<ContactDisc> discs_;
    std::vector<DiscField> fields_;
};

/// How far the surface under a contact may be from a plane that stands for it, in radii of the contact, and
/// the least cosine between its normal and the plane's.
constexpr double largest_sag = 0.6, least_facing = 0.8;

/// Before its plane, and under a hollow surface, no stress of a disc is more times larger than as far away
/// behind a plane.
constexpr double most_before_plane = 1.2, most_if_hollow = 1.9;

/// How far around a disc the surface is looked at in small pieces, in radii.
constexpr double close_reach = 4;

/// A place of the surface where a contact's stress may be largest.
struct SurfacePlace {
    Vec3 position = Vec3::Zero();  ///< m
    Vec3 normal = Vec3::Zero();    ///< outward
    /// What no grid has of the stress there, Pa: see unresolvedAt.
    SymmetricTensor unresolved = SymmetricTensor::Zero();
};

/// What contacts press on a body with, the part that a grid is too coarse for told apart.
struct ContactField {
    NearField near;
    std::vector<SurfacePlace> places;  ///< where they may pull most
    std::vector<PointForce> others;    ///< loads that no disc stands for
    /// What the near field leaves on the surface close to the discs, t - sigma n, in pieces that are small
    /// enough for it: the points of a grid are not.
    std::vector<PointForce> close = {};
};

}  // namespace sherd
