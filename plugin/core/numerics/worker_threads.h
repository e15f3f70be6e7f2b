#pragma once

#include <sherd/executor.h>

namespace sherd {

/// `workerThreads`, for work that has time: they give way to what is urgent (urgent_work.h).
Executor patientWorkerThreads(int count = 0);

}  // namespace sherd
