#include "core/parameters/faults.h"

namespace sherd {

void checkTogether(RangeChecks& checks, const Material& m) {
    checks.require(m.compressive_strength_pa >= m.tensile_strength_pa, "compressive_strength_pa",
                   m.compressive_strength_pa, "at least tensile_strength_pa");
}

void checkTogether(RangeChecks& checks, const SamplingSettings& s) {
    checks
        .require(s.largest_count >= s.smallest_count, "largest_count", s.largest_count,
                 "at least smallest_count")
        .require(s.largest_factor_if_thin_millions >= s.largest_factor_millions,
                 "largest_factor_if_thin_millions", s.largest_factor_if_thin_millions,
                 "at least largest_factor_millions");
}

void checkTogether(RangeChecks& checks, const GuideField& g) {
    checks
        .require(g.kind != GuideField::Kind::constant || isPositive(g.direction.norm()), "direction",
                 "zero or not finite", "a direction")
        .require(g.kind != GuideField::Kind::custom || g.custom, "custom", "empty", "a function");
}

void checkTogether(RangeChecks& checks, const FractureSettings& s) {
    checks.require(
        s.fragment_count <= s.largest_fragment_count, "fragment_count", s.fragment_count,
        "at most largest_fragment_count (" + std::to_string(s.largest_fragment_count) + "): raise that");
}

}  // namespace sherd
