#include "core/damage/failure_criterion.h"

namespace sherd {

// One line a criterion.
#define SHERD_FAILURE_CRITERIA(criterion) criterion(largest_principal_stress) criterion(mohr_coulomb)

#define SHERD_DECLARED(name) extern const FailureCriterion name;
#define SHERD_LISTED(name) &name,

SHERD_FAILURE_CRITERIA(SHERD_DECLARED)

const std::vector<const FailureCriterion*>& failureCriteria() {
    // Never destroyed: a world that lives as long as the program has threads that ask for it at the end.
    static const auto& all = *new std::vector<const FailureCriterion*>{SHERD_FAILURE_CRITERIA(SHERD_LISTED)};
    return all;
}

const FailureCriterion* failureCriterion(const std::string& name) {
    for (const FailureCriterion* criterion : failureCriteria())
        if (criterion->name == name) return criterion;
    return nullptr;
}

std::vector<std::string> failureCriterionNames() {
    std::vector<std::string> names;
    for (const FailureCriterion* criterion : failureCriteria()) names.emplace_back(criterion->name);
    return names;
}

}  // namespace sherd
