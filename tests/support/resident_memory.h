#pragma once

#include <unistd.h>

#include <fstream>

namespace sherd {

/// What the process has in memory, as Linux tells it.
inline double residentBytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0;
    file >> pages >> pages;
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace sherd
