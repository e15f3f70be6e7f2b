#pragma once

#include <functional>

namespace sherd {

/// Runs jobs on other threads: the app's job system, or `workerThreads`. It is given one job at a time, on
/// the thread that steps, and hands it to any thread. It may be late, run jobs out of order or all at once,
/// or lose them: the thread that needs the result of a job that nobody has begun does it itself. What a step
/// comes to is the same bit for bit with every executor, and with none. Jobs throw nothing and wait for
/// nothing but each other's memory; one takes up to some tens of milliseconds, or tenths of a second where a
/// body is not prepared. Stress problems that are made before they are needed (Budget::prepared_fragments)
/// have a thread of their own, unless there is no executor.
///
///     world.setExecutor([&](std::function<void()> job) { job_system.push(std::move(job)); });
using Executor = std::function<void(std::function<void()> job)>;

/// Threads of their own, `count` of them; at 0 one less than the machine has cores. They end with the last
/// copy of the executor; what has not begun by then is dropped. Fewer, perhaps none, where the system grants
/// no more.
Executor workerThreads(int count = 0);

}  // namespace sherd
