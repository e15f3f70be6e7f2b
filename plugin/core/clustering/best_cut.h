#pragma once

#include <sherd/types.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "core/clustering/crack_tree.h"

namespace sherd {

/// A particle of a part that is to be cut in two.
struct CutSample {
    Vec3 position = Vec3::Zero();  ///< m
    Vec3 axis = Vec3::Zero();      ///< of the wall, see wall_axes.h
    Mat3 metric = Mat3::Zero();    ///< see TensionMetric
    double volume = 0;             ///< m^3
    double pieces = 0;             ///< that it is to become
};

/// The plane along which a part breaks. Of many planes it is the one for which the product is largest of
/// - how wide the part is across it, in the measure of the metric where it runs: a crack runs where the
/// tension is
///   high, at right angles to it, and shortens what is long,
/// - how nearly the crack is opened alone, without shear: the mean of 1 / (1 + (shear / 0.2 of the
/// tension)^2),
/// - the balance 4 p (1 - p) of the pieces on both sides, p the share of them on one.
/// `spacing`: between particles, m. `seed` and `counter` choose between planes that are nearly as good. None
/// if all samples are at one place.
std::optional<CrackPlane> bestCut(const std::vector<CutSample>& samples, double spacing, std::uint64_t seed,
                                  std::uint64_t counter);

}  // namespace sherd
