#pragma once

#include <sherd/stress_field.h>
#include <sherd/types.h>

namespace sherd {

/// Eigenvalues of a stress tensor, Pa; tension is positive.
struct PrincipalStresses {
    double largest = 0, middle = 0, smallest = 0;
};

/// Both ends are found in the same way, so that the values of -s are those of s mirrored, bit for bit:
/// tension and compression are treated alike.
PrincipalStresses principalStresses(const SymmetricTensor& stress);

}  // namespace sherd
