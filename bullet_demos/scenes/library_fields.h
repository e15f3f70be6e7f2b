#pragma once

#include <sherd/material.h>
#include <sherd/settings.h>

#include <cstdint>
#include <string>

#include "scenes/json_fields.h"

namespace demo {

/// The key `material`: what sherd::Material::fromJson takes; files are relative to `folder`.
void readMaterial(Fields& body, sherd::Material& material, const std::string& folder);

/// The key `settings`: what sherd::Settings::fromJson takes. `seed` is that of settings without one.
void readSettings(Fields& body, sherd::Settings& settings, std::uint64_t seed);

}  // namespace demo
