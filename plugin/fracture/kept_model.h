#pragma once

#include <sherd/material.h>

#include <memory>

#include "core/mlpg/reduced/archive.h"

namespace sherd {

/// What answers blows on a solid without a factor, and the sampling that goes with it.
struct KeptModel {
    std::shared_ptr<const Discretisation> sampling;
    std::shared_ptr<const ReducedStress> reduced;
};

/// Reads or writes one. Of the sampling a file has what a blow asks for, not what only the making of a stress
/// problem needs.
template <class Archive>
void archiveModel(Archive& archive, const Material& material, KeptModel& model) {
    if constexpr (Archive::reads) {
        auto sampled = std::make_shared<Discretisation>();
        archiveFields(archive, *sampled);
        model.sampling = std::move(sampled);
        model.reduced = archiveReduced(archive, model.sampling, material, nullptr);
        archive.require(model.reduced != nullptr);
    } else {
        Discretisation sampled = *model.sampling;
        archiveFields(archive, sampled);
        archiveReduced(archive, model.sampling, material, model.reduced.get());
    }
}

/// The same model as a file would give it back, in half the memory: it answers with the same bits. The one
/// that it is given where a file could not hold it.
KeptModel asKept(const KeptModel& made, const Material& material);

}  // namespace sherd
