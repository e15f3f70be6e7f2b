#pragma once

#include <sherd/result.h>

#include <string>

/// The same figures as PaperRow has, of one run of ours.
struct Measured {
    int bodies_after = 0;  ///< the first break, as are all other figures
    double triangles_before = 0, triangles_after = 0;
    int particles = 0;
    double grid_ms = 0;           ///< sampling, with the table of neighbours
    double dynamics_ms = 0;       ///< a step in which nothing breaks: the median
    double stress_s = 0;          ///< loads, assembling, factoring, solving, stress from displacements
    double fragmentation_ms = 0;  ///< damage, clusters, surfaces and solids
    double render_s = 0;          ///< of the picture after the break
};

/// Reads report.json and after.seconds from a scene's folder. The error names the file that is missing or not
/// complete.
sherd::Result<Measured> readMeasured(const std::string& folder);
