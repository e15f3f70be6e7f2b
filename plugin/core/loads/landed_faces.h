#pragma once

#include <vector>

#include "core/loads/contact_loads.h"

namespace sherd {

/// Corners of a face that lands flat stand for all of it: each presses on the part that is nearer to it than
/// to the next ones, as far as the face touches, or as it gives way where it is tilted. What moves and
/// strikes with its own corners presses with these. Sets what the points of a strike have on faces.
void spreadOverFaces(const ContactBody& body, Strike& strike);

/// Of the surface about a corner of a face, without what lies in a hollow of it, or beside what it stands on.
void keepWhatTouches(const StrikePoint& corner, std::vector<PatchPart>& parts);

}  // namespace sherd
