#pragma once

#include <sherd/material.h>
#include <sherd/result.h>
#include <sherd/settings.h>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Says which constant, which setting or which combination of settings no stress can be solved with.
Status checkStressProblem(const Discretisation* solid, const Material& material,
                          const StressSettings& settings);

}  // namespace sherd
