#pragma once

#include <sherd/material.h>
#include <sherd/settings.h>

#include "scenes/json_fields.h"

namespace demo {

/// The key `material`: the name of one of the library's materials, or an object with the constants; `like`
/// names the library's material that gives those left out.
void readMaterial(Fields& body, sherd::Material& material);

/// The key `settings`: an object with the parts of sherd::Settings and their members by name; `quality` says
/// from which of `Settings::forQuality` it starts.
void readSettings(Fields& body, sherd::Settings& settings);

}  // namespace demo
