#pragma once

#include <vector>

#include "core/loads/contact_loads.h"
#include "core/stress/near_field.h"

namespace sherd {

/// The discs that stand for a contact; none at a corner, or where the surface under it is further from a
/// plane than `largest_sag`.
std::vector<ContactDisc> contactDiscs(const SurfaceTree& surface, const ContactPatch& patch);

/// Contacts as discs on the planes of the surface under them: there the body is nearly a half-space, less
/// what is missing of it. A contact that hangs over an edge is the part of a disc that is on the body, and
/// one more disc on each further face that it presses on. Contacts that are none stay loads.
ContactField contactField(const ContactBody& body, const std::vector<ContactPatch>& patches);

}  // namespace sherd
