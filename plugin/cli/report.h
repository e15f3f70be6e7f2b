#pragma once

#include <sherd/stress_model.h>

#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/case_file.h"

namespace sherd::cli {

/// The content of the report. Wall-clock times are inside `ms` and nowhere else.
nlohmann::ordered_json makeReport(const Arguments& arguments, const StressCase& problem,
                                  const StressModel& model, const StressField& field);

Status writeReport(const nlohmann::ordered_json& report, const std::string& path);

}  // namespace sherd::cli
