#pragma once

#include <vector>

#include "core/loads/contact_pulse.h"
#include "core/loads/mobility.h"

namespace sherd {

/// A body that a load goes through on its way to what stands still.
struct StackBody {
    int number = 0;  ///< of the partner that it is
    Mobility mobility;
    /// Shortening over force, m/N: that of a rod as long as the body is along the strike, and of its volume.
    double compliance_m_n = 0;
};

/// A contact between two bodies that the struck one does not take part in.
struct StackContact {
    int first = 0, second = -1;                      ///< numbers of partners; -1: what does not give way
    Vec3 point = Vec3::Zero(), push = Vec3::Zero();  ///< m; unit, the direction in which it pushes `first`
    double stiffness_n_m = 0;
};

/// A strike on another body of the stack.
struct DistantStrike {
    int number = 0;                                  ///< of the partner that is struck
    Vec3 point = Vec3::Zero(), push = Vec3::Zero();  ///< m; unit, the direction in which it is pushed
    double speed_m_s = 0;
    double striker_mobility = 0;  ///< felt at the point along the push, 1/kg; 0: it does not give way
    HertzContact hertz;

    bool strikes() const { return speed_m_s > 0; }
};

/// What a struck body leans on beyond its own partners, and what those beyond are struck by: a strike on the
/// top of a column goes through all of it. Asset frame of the body.
struct Stack {
    std::vector<StackBody> bodies;  ///< partners of the blow that may move, direct ones included
    std::vector<StackContact> contacts;
    DistantStrike strike;  ///< strikes only where nothing strikes the body itself

    bool empty() const { return bodies.empty(); }
    const StackBody* body(int number) const;
    /// Of the strike with all of the striker's mass, J: as though the stack gave way nowhere.
    double largestEnergy() const;
};

}  // namespace sherd
