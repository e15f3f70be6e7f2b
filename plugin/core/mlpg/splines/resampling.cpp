#include "core/mlpg/splines/resampling.h"

#include <algorithm>
#include <iterator>

#include "core/stress/loaded_places.h"

namespace sherd {
namespace {

/// Macro cells of the finer grids fill those of the coarser: what these hold at the border keeps its volume.
int cellsOfMacroCell(const SplineProblem& problem) {
    return isNearlyIncompressible(problem.elasticity) ? problem.space->degree : 1;
}

/// Cells along a cube of high stress. Smaller ones are mostly border, larger ones are mostly cells that need
/// no finer grid.
int cellsOfCube(const SplineProblem& problem) {
    constexpr int cells = 4;
    const int multiple = cellsOfMacroCell(problem);
    return (cells + multiple - 1) / multiple * multiple;
}

Result<std::vector<Zoom>> zoomsAroundLoads(const SplineProblem& problem, const SplineField& coarse,
                                           const BodyLoads& loads, const ResamplingReach& reach) {
    // A load over a larger fraction of the body is not a contact, and the grid resolves it.
    constexpr double largest_patch_of_body = 0.2;
    const CellParts& whole = problem.parts();
    const double largest_patch =
        largest_patch_of_body * whole.count.cast<double>().cwiseProduct(whole.edges).norm();
    std::vector<Zoom> zooms;
    for (const CellBox& box :
         boxesAroundLoads(*coarse.parts, loads.forces, largest_patch, reach, cellsOfMacroCell(problem))) {
        const Result<ZoomGrid> grid = zoomGrid(*problem.solid->surface, *coarse.parts, *coarse.space, box,
                                               problem.elasticity, problem.supports);
        if (!grid) return Error{grid.error()};
        Result<Zoom> zoom = zoomIn(grid.value(), coarse, problem.elasticity, loads);
        if (!zoom) return Error{zoom.error()};
        zooms.push_back(std::move(zoom).value());
    }
    return zooms;
}

/// The next finer grids around the loads inside of zooms.
Result<std::vector<Zoom>> zoomsInto(const SplineProblem& problem, const std::vector<Zoom>& coarser,
                                    const ResamplingReach& reach) {
    std::vector<Zoom> finer;
    for (const Zoom& zoom : coarser) {
        Result<std::vector<Zoom>> inside = zoomsAroundLoads(problem, zoom.field, zoom.loads, reach);
        if (!inside) return inside;
        std::move(inside.value().begin(), inside.value().end(), std::back_inserter(finer));
    }
    return finer;
}

/// Samples where the surface is free: further than a cell from loads and supports.
std::vector<int> freeSamples(const SplineProblem& problem, const std::vector<SurfaceSample>& samples,
                             const BodyLoads& loads) {
    std::vector<PointForce> acting = loads.forces;
    for (const SupportSpring& support : problem.supports) acting.push_back({support.position, Vec3::Zero()});
    const LoadedPlaces loaded(acting, problem.parts().edges.maxCoeff());
    std::vector<int> free;
    for (size_t s = 0; s < samples.size(); ++s)
        if (!loaded.isNear(samples[s].position)) free.push_back(static_cast<int>(s));
    return free;
}

}  // namespace

/// A zoom at high stress, or the whole body, and the samples that are judged on it.
struct Resampling::Place {
    Zoom zoom;
    CellBox box;  ///< that the zoom fills, in cells of its grid
    KeptZooms::Path path;
    std::vector<int> samples;
};

/// High stress on a place.
struct Resampling::Spot {
    const Place* place;
    HighStress high;
};

Resampling::Resampling(const SplineProblem& problem, ResamplingReach reach, long long largest_entries)
    : reach_(reach),
      largest_entries_(largest_entries),
      kept_(std::make_shared<KeptZooms>(2 * largest_entries)) {
    if (reach.rounds > 0) samples_ = surfaceSamples(*problem.solid->surface, problem.parts());
}

/// The worst first. What lies in a zoom around loads is left to it.
std::vector<Resampling::Spot> Resampling::spotsOn(const SplineProblem& problem,
                                                  const std::vector<Place>& places,
                                                  const std::vector<Zoom>& around_loads,
                                                  double peak_pa) const {
    std::vector<Spot> spots;
    for (const Place& place : places) {
        std::vector<int> samples;
        for (const int s : place.samples)
            if (std::none_of(around_loads.begin(), around_loads.end(),
                             [&](const Zoom& zoom) { return isInside(zoom, samples_[s].position); }))
                samples.push_back(s);
        const SplineField& field = place.zoom.field;
        const auto stresses = stressAtSamples(field, problem.elasticity, samples_, samples);
        for (HighStress& high :
             highStresses(*field.parts, cellsOfCube(problem), samples_, stresses, peak_pa, reach_.error))
            spots.push_back({&place, std::move(high)});
    }
    std::stable_sort(spots.begin(), spots.end(),
                     [](const Spot& a, const Spot& b) { return a.high.rank > b.high.rank; });
    return spots;
}

Result<std::vector<Resampling::Place>> Resampling::atHighStress(const SplineProblem& problem,
                                                                const std::vector<Place>& coarser,
                                                                const std::vector<Zoom>& around_loads,
                                                                double peak_pa, long long& entries) const {
    // One cell, in which most functions of the finer grid are held, is as good as two.
    const Eigen::Vector3i border = Eigen::Vector3i::Constant(cellsOfMacroCell(problem));
    std::vector<Place> finer;
    for (Spot& spot : spotsOn(problem, coarser, around_loads, peak_pa)) {
        if (entries >= largest_entries_) break;
        const Place& place = *spot.place;
        const SplineField& field = place.zoom.field;
        const CellBox box{(spot.high.cells.lower - border).cwiseMax(place.box.lower),
                          (spot.high.cells.upper + border).cwiseMin(place.box.upper)};
        KeptZooms::Path path = place.path;
        path.push_back(box);
        const auto grid = kept_->at(path, [&]() -> Result<ZoomGrid> {
            Result<ZoomGrid> made = zoomGrid(*problem.solid->surface, *field.parts, *field.space, box,
                                             problem.elasticity, problem.supports);
            if (made)
                if (const Status factored = factorZoom(made.value()); !factored)
                    return Error{factored.error()};
            return made;
        });
        if (!grid) return Error{grid.error()};
        Result<Zoom> zoom = zoomIn(*grid.value(), field, problem.elasticity, place.zoom.loads);
        if (!zoom) return Error{zoom.error()};
        entries += zoom.value().stiffness_entries;
        finer.push_back(
            {std::move(zoom).value(), grid.value()->box, std::move(path), std::move(spot.high.samples)});
    }
    return finer;
}

Result<std::vector<Zoom>> Resampling::resample(const SplineProblem& problem, const SplineField& whole,
                                               const BodyLoads& loads) const {
    std::vector<Zoom> zooms;
    if (reach_.rounds < 1) return zooms;
    const Eigen::Vector3i beyond = Eigen::Vector3i::Constant(2 * cellsOfCube(problem));
    const CellBox everywhere{-beyond, problem.parts().count + beyond};
    std::vector<Place> places;
    places.push_back(
        {Zoom{whole, loads, everywhere, 0}, everywhere, {}, freeSamples(problem, samples_, loads)});
    double peak_pa = 0;
    for (const SampledStress& stress :
         stressAtSamples(whole, problem.elasticity, samples_, places.front().samples))
        peak_pa = std::max(peak_pa, stress.tension_pa);

    long long entries = 0;
    Result<std::vector<Zoom>> around_loads = zoomsAroundLoads(problem, whole, loads, reach_);
    if (!around_loads) return around_loads;
    for (int round = 1;; ++round) {
        Result<std::vector<Place>> finer =
            atHighStress(problem, places, around_loads.value(), peak_pa, entries);
        if (!finer) return Error{finer.error()};
        places = std::move(finer).value();
        for (const Place& place : places) zooms.push_back(place.zoom);
        zooms.insert(zooms.end(), around_loads.value().begin(), around_loads.value().end());
        if (round == reach_.rounds) return zooms;
        around_loads = zoomsInto(problem, around_loads.value(), reach_);
        if (!around_loads) return around_loads;
    }
}

}  // namespace sherd
