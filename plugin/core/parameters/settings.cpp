#include <sherd/settings.h>

#include "core/parameters/faults.h"

namespace sherd {

Status SamplingSettings::validate() const {
    return statusOf("SamplingSettings", *this);
}

Status StressSettings::validate() const {
    return statusOf("StressSettings", *this);
}

Status ContactSettings::validate() const {
    return statusOf("ContactSettings", *this);
}

Status GuideField::validate() const {
    return statusOf("GuideField", *this);
}

Status FractureSettings::validate() const {
    return statusOf("FractureSettings", *this);
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
