#pragma once

#include <sherd/result.h>
#include <sherd/types.h>

#include <string>
#include <vector>

namespace sherd::cli {

/// Reads the columns x, y, z of a CSV with a header; others are passed over. The error names file and line.
Result<std::vector<Vec3>> readPoints(const std::string& path);

/// Stress at points, and what kind of point each is.
struct StressTable {
    std::vector<Vec3> positions;            ///< m
    std::vector<SymmetricTensor> stresses;  ///< Pa
    std::vector<const char*> kinds;         ///< of each row, or empty: no such column
    std::vector<double> spacings;           ///< of the particles there, m, or empty: no such column
};

/// Writes x,y,z,s_xx,s_yy,s_zz,s_xy,s_yz,s_zx,s_max_principal and, if known, spacing_m and kind; numbers have
/// the digits that give the same bits when read.
Status writeStress(const StressTable& table, const std::string& path);

}  // namespace sherd::cli
