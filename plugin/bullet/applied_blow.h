#pragma once

#include <sherd/push.h>
#include <sherd/result.h>

#include <vector>

#include "bullet/contact_collector.h"

namespace sherd {

/// Says which figure of a push is out of range, or that there is none.
Status checkPushes(const std::vector<Push>& pushes);

/// Pushes as contacts of the body: each stops a striker of the speed v that carries J = m v. Where v is not
/// known it is J (n . K n), with which m is the body's own effective mass at the point, and 1/2 m v^2 what J
/// gives to the body.
StruckBreakable asContacts(Breakable& breakable, const std::vector<Push>& pushes);

}  // namespace sherd
