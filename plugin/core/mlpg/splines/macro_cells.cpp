#include "core/mlpg/splines/macro_cells.h"

#include <algorithm>
#include <map>

namespace sherd {
namespace {

constexpr double well_filled = 0.3;  // a macro cell that fills less of its block does not stand alone

Eigen::Vector3i blockOf(const CellPart& part, int width) {
    return part.cell / width;  // cells of a solid begin at 0
}

/// Numbers the sets of parts that are connected inside a block, per part; returns how many there are.
int numberConnected(const CellParts& solid, int width, std::vector<int>& of_part) {
    of_part.assign(solid.parts.size(), -1);
    int count = 0;
    std::vector<int> queue;
    for (int first = 0; first < static_cast<int>(of_part.size()); ++first) {
        if (of_part[first] >= 0) continue;
        const Eigen::Vector3i block = blockOf(solid.parts[first], width);
        of_part[first] = count;
        queue.assign(1, first);
        for (size_t next = 0; next < queue.size(); ++next)
            for (const int other : solid.neighbours[queue[next]])
                if (of_part[other] < 0 && blockOf(solid.parts[other], width) == block) {
                    of_part[other] = count;
                    queue.push_back(other);
                }
        ++count;
    }
    return count;
}

/// Per set of parts, the one that it goes with: itself, or a well-filled neighbour if it is not.
std::vector<int> hosts(const CellParts& solid, int width, const std::vector<int>& of_part, int count) {
    std::vector<double> fill(count, 0.0);
    for (size_t part = 0; part < of_part.size(); ++part) fill[of_part[part]] += solid.parts[part].fill;
    const double least = well_filled * width * width * width;
    std::vector<std::map<int, double>> contact(count);  // of those that are ill filled, with others
    for (size_t part = 0; part < of_part.size(); ++part) {
        const int own = of_part[part];
        if (fill[own] >= least) continue;
        for (const int other : solid.neighbours[part])
            if (fill[of_part[other]] >= least)
                contact[own][of_part[other]] += std::min(solid.parts[part].fill, solid.parts[other].fill);
    }
    std::vector<int> host(count);
    for (int own = 0; own < count; ++own) {
        const auto most = std::max_element(contact[own].begin(), contact[own].end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        host[own] = most == contact[own].end() ? own : most->first;
    }
    return host;
}

}  // namespace

std::vector<std::vector<int>> macroCells(const CellParts& solid, int width) {
    std::vector<int> of_part;
    const int count = numberConnected(solid, width, of_part);
    const std::vector<int> host = hosts(solid, width, of_part, count);
    std::vector<std::vector<int>> cells(count);
    for (size_t part = 0; part < of_part.size(); ++part)
        cells[host[of_part[part]]].push_back(static_cast<int>(part));
    cells.erase(std::remove_if(cells.begin(), cells.end(), [](const auto& cell) { return cell.empty(); }),
                cells.end());
    return cells;
}

}  // namespace sherd
