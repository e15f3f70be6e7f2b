#pragma once

#include "core/clustering/clusters.h"
#include "fracture/pipeline.h"
#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Number of clusters for the damaged part: the settings' own, or what the strain energy pays for, within the
/// limit.
int wantedClusters(const BreakableSolid& body, const Damage& damage, const Discretisation& solid,
                   double strain_energy_j);

/// Strain energy below which no crack runs through even the thinnest section, J (Griffith: its faces cost G_c
/// each area).
double smallestCrackEnergy(const BreakableSolid& body);

/// Gives every cut surface its body and the boxes that stand for it in collisions.
std::vector<Fragment> makeFragments(const BreakableSolid& body, const Discretisation& solid,
                                    const FragmentLabels& labels, const FragmentSurfaces& surfaces);

/// Marks the pieces below the smallest fragment as dropped, but never the largest piece.
void markDropped(const BreakableSolid& body, std::vector<Fragment>& fragments);

/// Compares volume and mass of all fragments with the body's.
void addConservationErrors(const BreakableSolid& body, BlowOutcome& out);

}  // namespace sherd
