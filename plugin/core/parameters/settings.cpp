#include <sherd/settings.h>

#include "core/numerics/range_checks.h"

namespace sherd {

Status SamplingSettings::validate() const {
    return RangeChecks("SamplingSettings")
        .require(isNotNegative(spacing_m), "spacing_m", spacing_m,
                 "0 (chosen from the wall thickness) or positive, in m")
        .require(isWithin(layers_across_wall, 0.5, 20), "layers_across_wall", layers_across_wall,
                 "between 0.5 and 20")
        .require(smallest_count >= 1, "smallest_count", smallest_count, "at least 1")
        .require(largest_count >= smallest_count, "largest_count", largest_count, "at least smallest_count")
        .require(isPositive(largest_factor_millions), "largest_factor_millions", largest_factor_millions,
                 "positive")
        .require(largest_factor_if_thin_millions >= largest_factor_millions,
                 "largest_factor_if_thin_millions", largest_factor_if_thin_millions,
                 "at least largest_factor_millions")
        .require(moment_order >= 0 && moment_order <= 6 && moment_order % 2 == 0, "moment_order",
                 moment_order, "0, 2, 4 or 6")
        .require(isWithin(cells_per_spacing, 1, 4), "cells_per_spacing", cells_per_spacing, "between 1 and 4")
        .require(isWithin(smallest_fill, 0, 0.9), "smallest_fill", smallest_fill, "between 0 and 0.9")
        .status();
}

Status StressSettings::validate() const {
    // Near one spacing particles hardly see each other (errors of 700 %); beyond four the factor fills
    // without a gain in accuracy.
    return RangeChecks("StressSettings")
        .require(support_radius == 0 || isWithin(support_radius, 1.2, 4), "support_radius", support_radius,
                 "0 (the form's own default) or between 1.2 and 4 particle spacings")
        .require(isWithin(resampling_rounds, 0, 4), "resampling_rounds", resampling_rounds, "between 0 and 4")
        .require(isWithin(resampling_margin, 1, 6), "resampling_margin", resampling_margin,
                 "between 1 and 6 cells")
        .status();
}

Status ContactSettings::validate() const {
    return RangeChecks("ContactSettings")
        .require(isPositive(partner_youngs_modulus_pa), "partner_youngs_modulus_pa",
                 partner_youngs_modulus_pa, "positive, in Pa")
        .require(isWithin(partner_poisson_ratio, 0, 0.5), "partner_poisson_ratio", partner_poisson_ratio,
                 "between 0 and 0.5")
        .require(isPositive(shortest_contact_s), "shortest_contact_s", shortest_contact_s, "positive, in s")
        .require(std::isfinite(longest_contact_s) && longest_contact_s >= shortest_contact_s,
                 "longest_contact_s", longest_contact_s, "at least shortest_contact_s, in s")
        .require(isPositive(smallest_patch), "smallest_patch", smallest_patch,
                 "positive (fraction of the wall thickness)")
        .require(largest_patch > 0 && largest_patch <= 1, "largest_patch", largest_patch,
                 "above 0 and at most 1 (fraction of the body's radius)")
        .status();
}

Status GuideField::validate() const {
    return RangeChecks("GuideField")
        .require(isWithin(penalty, 0, 1), "penalty", penalty, "between 0 and 1")
        .require(kind != Kind::constant || isPositive(direction.norm()), "direction", "zero or not finite",
                 "a direction")
        .require(kind != Kind::custom || custom, "custom", "empty", "a function")
        .status();
}

Status FractureSettings::validate() const {
    if (const Status field = guide.validate(); !field) return field;
    return RangeChecks("FractureSettings")
        .require(isNotNegative(strength_field_minimum), "strength_field_minimum", strength_field_minimum,
                 "0 (not known) or positive")
        .require(fragment_count >= 0, "fragment_count", fragment_count,
                 "0 (what the strain energy pays for) or the number of clusters")
        .require(largest_fragment_count >= 2, "largest_fragment_count", largest_fragment_count, "at least 2")
        .require(fragment_count <= largest_fragment_count, "fragment_count", fragment_count,
                 "at most largest_fragment_count")
        .require(energy_into_cracks > 0 && energy_into_cracks <= 1, "energy_into_cracks", energy_into_cracks,
                 "a fraction above 0 and at most 1")
        .require(isNotNegative(smallest_fragment_m3), "smallest_fragment_m3", smallest_fragment_m3,
                 "0 (1/200 of the first body) or positive, in m^3")
        .require(isWithin(damage_waves, 1, 20), "damage_waves", damage_waves, "between 1 and 20")
        .require(isWithin(crack_roughness, 0, 0.5), "crack_roughness", crack_roughness,
                 "between 0 and 0.5 (fraction of the particle spacing)")
        .require(isNotNegative(rest_after_break_s), "rest_after_break_s", rest_after_break_s,
                 "0 or positive, in s")
        .status();
}

Settings Settings::forQuality(Quality quality) {
    Settings settings;
    SamplingSettings& sampling = settings.sampling;
    StressSettings& stress = settings.stress;
    switch (quality) {
        case Quality::preview:
            sampling.layers_across_wall = 2;
            sampling.smallest_count = 80;
            sampling.largest_factor_millions = 1.85;
            sampling.largest_factor_if_thin_millions = 6;
            break;
        case Quality::game:
            break;
        case Quality::film:
            sampling.layers_across_wall = 6;
            sampling.smallest_count = 2000;
            sampling.largest_factor_millions = 90;
            sampling.largest_factor_if_thin_millions = 140;
            sampling.moment_order = 6;
            stress.basis = Basis::cubic;
            stress.resampling_rounds = 3;
            stress.resampling_margin = 3;
            break;
    }
    return settings;
}

Status Settings::validate() const {
    for (const Status& part :
         {sampling.validate(), stress.validate(), contact.validate(), fracture.validate()})
        if (!part) return part;
    return success();
}

}  // namespace sherd
