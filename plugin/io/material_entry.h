#pragma once

#include <sherd/material.h>

#include <string>

#include "io/json_entry.h"
#include "io/json_fields.h"

namespace sherd {

/// The material that an entry names (one of the library's, or a file relative to `folder`) or describes.
/// Throws BadEntry.
Material materialOf(const JsonEntry& entry, const std::string& folder, Missing missing);

}  // namespace sherd
