#include <sherd/budget.h>

#include <cmath>
#include <limits>
#include <string>

namespace sherd {

namespace {

Status check(bool in_range, const char* field, const char* possible) {
    if (in_range) return success();
    return Error{"budget." + std::string(field) + " must be " + possible};
}

}  // namespace

Budget Budget::none() {
    Budget budget;
    budget.shortest_wait_s = budget.foresight_s = 0;
    budget.prepared_fragments = 0;
    budget.fragments_per_step = budget.fragments_alive = std::numeric_limits<int>::max();
    return budget;
}

Status Budget::validate() const {
    const auto not_below = [](double value, double least) { return std::isfinite(value) && value >= least; };
    if (Status ok = check(not_below(shortest_wait_s, 0), "shortest_wait_s", "0 (none waits) or more, in s");
        !ok)
        return ok;
    if (Status ok = check(not_below(longest_wait_s, shortest_wait_s), "longest_wait_s",
                          "shortest_wait_s or more, in s");
        !ok)
        return ok;
    if (Status ok = check(not_below(milliseconds_per_step, 0), "milliseconds_per_step",
                          "0 (the step's length) or more");
        !ok)
        return ok;
    if (Status ok = check(not_below(foresight_s, 0) && foresight_s <= 1, "foresight_s",
                          "between 0 (none is foreseen) and 1, in s");
        !ok)
        return ok;
    if (Status ok = check(solves_per_step > 0, "solves_per_step", "1 or more"); !ok) return ok;
    const bool is_known =
        priority == Priority::hardest || priority == Priority::nearest || priority == Priority::largest;
    if (Status ok = check(is_known, "priority", "hardest, nearest or largest"); !ok) return ok;
    if (Status ok = check(viewpoint.allFinite(), "viewpoint", "finite, in m"); !ok) return ok;
    if (Status ok = check(prepared_fragments >= 0, "prepared_fragments", "0 (none is prepared) or more"); !ok)
        return ok;
    if (Status ok = check(fragments_per_step >= 2, "fragments_per_step", "2 or more"); !ok) return ok;
    return check(fragments_alive >= 2, "fragments_alive", "2 or more");
}

}  // namespace sherd
