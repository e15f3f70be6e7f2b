#pragma once

#include <sherd/result.h>

#include <string>

/// Size of the sheet in pixels, for POV-Ray.
inline constexpr int sheet_width = 1920, sheet_height = 1020;

/// Writes a scene file for POV-Ray that lays before.png and after.png of all scenes below `folder` out on one
/// sheet.
sherd::Status writeSheet(const std::string& folder, const std::string& path);
