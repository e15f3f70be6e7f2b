#pragma once

#include <sherd/types.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace sherd {

/// Points of a reference solution far from the loads, and the largest principal stress there, Pa.
struct CaseReference {
    std::vector<Vec3> points;
    std::vector<double> largest_principal;
};

/// A table of tests/data/cases.
inline CaseReference readReference(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    CaseReference reference;
    while (std::getline(in, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream row(line);
        double value[11] = {};
        for (double& v : value) row >> v;
        if (value[10] == 0) continue;
        reference.points.emplace_back(value[0], value[1], value[2]);
        reference.largest_principal.push_back(value[9]);
    }
    return reference;
}

}  // namespace sherd
