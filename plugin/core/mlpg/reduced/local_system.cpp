// The equations of the functions about loads: which these are, and their factors.

#include <algorithm>
#include <utility>

#include "core/linear_algebra/dense_kernels.h"
#include "core/mlpg/reduced/reduced_model.h"

namespace sherd {

namespace {

/// Below this share of all functions the functions about a load are a small part of the solid.
constexpr double largest_local_share = 0.6;

}  // namespace

/// Whether functions are so many of a component's that nothing else holds them, or nearly so.
bool ReducedModel::coversAComponent(const std::vector<int>& functions) const {
    std::vector<int> among(static_cast<std::size_t>(problem_->space->component_count), 0);
    for (const int function : functions) ++among[problem_->space->component[function]];
    for (std::size_t c = 0; c < among.size(); ++c)
        if (among[c] > largest_local_share * functions_of_component_[c]) return true;
    return false;
}

/// Factors the equations of functions that are joined. False if they are not definite.
bool ReducedModel::factorBlock(LocalSystem::Block& block) const {
    block.factor = stiffness_.lowerPart(block.functions);
    block.factor.diagonal() *= 1 + block.stiffening;
    const int size = block.size(), count = modes_.count;
    if (!choleskyInPlace(block.factor.data(), size, size)) return false;
    block.coupling.resize(count, size);
    for (int i = 0; i < size; i += 3)
        modes_.forcesOn(*problem_, block.functions[i / 3], &block.coupling(0, i));
    divideByTransposed(block.factor.data(), size, size, block.coupling.data(), count, count);
    block.taken.resize(count, count);
    setToSquare(block.coupling.data(), count, size, count, block.taken.data(), count);
    return true;
}

/// Adds the equations of functions that are joined, as they were `before` if they were there. False if they
/// are not definite.
bool ReducedModel::addBlock(std::vector<int> functions, float stiffening, LocalSystem& before,
                            LocalSystem& system) const {
    const auto same =
        std::find_if(before.blocks.begin(), before.blocks.end(), [&](const LocalSystem::Block& block) {
            return block.functions == functions && block.stiffening == stiffening;
        });
    LocalSystem::Block& block = system.blocks.emplace_back();
    if (same != before.blocks.end()) {
        block = std::move(*same);
        same->functions.clear();
    } else {
        block.functions = std::move(functions);
        block.stiffening = stiffening;
        if (!factorBlock(block)) return false;
    }
    system.modes_factor.triangularView<Eigen::Lower>() += block.taken;
    return true;
}

/// False if the equations are not definite.
bool ReducedModel::factor(float stiffening, LocalSystem& before, LocalSystem& system) const {
    system.blocks.clear();
    system.modes_factor.setIdentity(modes_.count, modes_.count);
    for (std::vector<int>& functions : stiffness_.joined(system.functions))
        if (!addBlock(std::move(functions), stiffening, before, system)) return false;
    return choleskyInPlace(system.modes_factor.data(), modes_.count, modes_.count);
}

/// Assembles and factors the equations of the functions about loads, unless `kept` has just these.
Status ReducedModel::prepareAbout(std::vector<int> functions, LocalSystem& kept) const {
    if (!functions.empty() && kept.functions == functions) return success();
    if (coversAComponent(functions))
        return Error{"The loads act on so large a part of the body that nothing is left to reduce."};
    LocalSystem system;
    system.functions = std::move(functions);
    // Where the functions do nearly all that a mode can, what is left of that is rounding: a little more
    // stiffness takes that away, and leaves such motions to the modes.
    for (const float more : {0.0f, 1e-5f, 1e-4f}) {
        if (!factor(more, kept, system)) continue;
        kept = std::move(system);
        return success();
    }
    kept = {};
    return Error{"The reduced equations are not definite where the loads act."};
}

}  // namespace sherd
