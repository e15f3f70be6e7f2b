#pragma once

#include <vector>

#include "core/loads/contact_loads.h"
#include "core/stress/near_field.h"

namespace sherd {

/// The least share of a disc, by its traction, that lies on the body. In a hollow it is more, since the
/// stress of a disc is larger there: no stress of a contact is to be larger than that of its force on a whole
/// disc over `least_share`.
constexpr double least_share = 0.35, least_share_in_hollow = 0.45;

/// The discs that stand for a contact; none at a corner, in a groove, beneath an overhang, where the surface
/// under it is further from a plane than `largest_sag`, or where too little of a disc lies on it.
std::vector<ContactDisc> contactDiscs(const SurfaceTree& surface, const ContactPatch& patch);

/// Contacts as discs on the planes of the surface under them: there the body is nearly a half-space, less
/// what is missing of it. A contact that hangs over an edge is the part of a disc that is on the body, and
/// one more disc on each further face that it presses on. Contacts that are none stay loads. `spacing_m`: of
/// the grid on which the rest is solved.
ContactField contactField(const ContactBody& body, const std::vector<ContactPatch>& patches,
                          double spacing_m);

}  // namespace sherd
