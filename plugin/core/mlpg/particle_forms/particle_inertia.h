#pragma once

#include "core/mlpg/inertia_relief.h"
#include "core/mlpg/particle_forms/stress_problem.h"

namespace sherd {

/// Galerkin: f_a = sum over sub-domains P of phi_a(x_P) int_P b + sum_c g_ca . int_c b (x - x_P)^T, cell by
/// cell with its second moment.
InertiaRelief galerkinInertia(const StressProblem& problem);

/// Heaviside: the rows of sub-domain P get int_P b.
InertiaRelief heavisideInertia(const StressProblem& problem);

}  // namespace sherd
