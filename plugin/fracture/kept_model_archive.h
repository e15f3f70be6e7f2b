#pragma once

#include <memory>

#include "core/mlpg/reduced/archive.h"
#include "fracture/kept_model.h"

namespace sherd {

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

}  // namespace sherd
