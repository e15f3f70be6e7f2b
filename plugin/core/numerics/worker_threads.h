#pragma once

#include <sherd/executor.h>

#include "core/numerics/urgent_work.h"

namespace sherd {

/// `workerThreads`, for work that has time.
Executor patientWorkerThreads(GivesWay to, int count = 0);

}  // namespace sherd
