#include <sherd/material.h>

#include "core/parameters/faults.h"

namespace sherd {

Status Material::validate() const {
    return statusOf("Material '" + name + "'", *this);
}

}  // namespace sherd
