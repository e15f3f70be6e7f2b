#pragma once

#include <vector>

#include "core/damage/material_strength.h"
#include "core/mlpg/reduced/damage_reading.h"
#include "core/numerics/made_once.h"

namespace sherd {

/// The strength of a body, kept where its stress is read; those strengths are found when first needed. All
/// members may be called from several threads at once.
class BodyStrength {
  public:
    /// As MaterialStrength.
    BodyStrength(const Material& material, double scatter_length_m, const StrengthSettings& settings)
        : strength_(material, scatter_length_m, settings),
          scatter_length_m_(scatter_length_m),
          is_painted_(static_cast<bool>(settings.field)) {}

    /// At any point.
    const MaterialStrength& at() const { return strength_; }
    double scatterLength() const { return scatter_length_m_; }
    /// The app gave a strength field.
    bool isPainted() const { return is_painted_; }

    /// Where the full solves of a body read its stress, Pa (strengthsAtSamples); of one sampling.
    const std::vector<double>& atSamples(const Discretisation& sampling) const {
        return at_samples_.get([&] { return strengthsAtSamples(strength_, sampling); });
    }
    /// Where its reduced model does, Pa (DamageReading::strengths); of one reading.
    const std::vector<double>& atPoints(const DamageReading& reading) const {
        return at_points_.get([&] { return reading.strengths(strength_); });
    }
    /// The least of the last, Pa. With a strength field, which belongs to the app and is not called here, the
    /// least that it allows.
    double weakest(const DamageReading& reading) const;

  private:
    MaterialStrength strength_;
    double scatter_length_m_;
    bool is_painted_;
    mutable MadeOnce<std::vector<double>> at_samples_, at_points_;
    mutable MadeOnce<double> weakest_;
};

}  // namespace sherd
