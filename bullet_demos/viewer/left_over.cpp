#include "viewer/left_over.h"

#include <algorithm>
#include <vector>

namespace demo {

void leaveToItself(std::unique_ptr<LeftOver> work) {
    static std::vector<std::unique_ptr<LeftOver>> kept;
    kept.erase(std::remove_if(kept.begin(), kept.end(), [](const auto& other) { return other->done(); }),
               kept.end());
    kept.push_back(std::move(work));
}

}  // namespace demo
