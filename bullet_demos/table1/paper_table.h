#pragma once

#include <array>

/// A row of Table 1 of N. Liu, X. He, S. Li, G. Wang, Meshless simulation of brittle fracture, Computer
/// Animation and Virtual Worlds 22 (2011), as printed but for the units: "3 minutes 4 seconds" is 184 s here.
/// Their machine: 2.93 GHz.
struct PaperRow {
    const char* scene;
    const char* model;
    int bodies_after;
    double triangles_before, triangles_after;
    int particles;
    double grid_ms, dynamics_ms, stress_s, fragmentation_ms, render_s;
};

inline constexpr std::array<PaperRow, 6> paper_table = {{
    {"plaster_wall", "Plaster wall", 37, 154.6e3, 161.8e3, 968, 9, 0.3, 5.650, 9.240, 3},
    {"glass_wall", "Glass wall", 37, 154.6e3, 162.7e3, 968, 9, 0.3, 5.649, 8.397, 50},
    {"wood_wall", "Wood wall", 15, 154.6e3, 161.8e3, 968, 9, 0.3, 5.741, 2.690, 4},
    {"coffee_plate", "Coffee plate", 10, 115.1e3, 118.5e3, 4857, 10, 2.0, 47, 5000, 27},
    {"coffee_cup", "Coffee cup", 10, 220.5e3, 228.5e3, 12988, 20, 5.5, 184, 18000, 68},
    {"plane", "Plane", 7, 52.5e3, 91e3, 2739, 14, 1.1, 30.7, 110000, 7},
}};
