#pragma once

#include <LinearMath/btTransform.h>

#include <optional>

#include "bullet/island/island_state.h"
#include "core/loads/mobility.h"

class btCollisionObject;
class btRigidBody;

namespace sherd {

/// The state of a body as it is now.
BodyState stateOf(const btRigidBody& body);

/// Of one point of an object before the solve. Accelerations are along the normal, in m/s^2.
struct PointMotion {
    btVector3 velocity = btVector3(0, 0, 0);
    btScalar gravity = 0;
    btScalar fall = 0;  ///< the same while the body falls or flies, 0 while something holds it
    btVector3 spin = btVector3(0, 0, 0);  ///< of the body, rad/s
    btVector3 arm = btVector3(0, 0, 0);   ///< from the body's centre of mass to the point, m
};

/// `state` may be nullptr: then the object moves as it does now.
PointMotion motionAt(const btCollisionObject& object, const BodyState* state, const btVector3& point,
                     const btVector3& normal, double time_step_s);

/// Closing speed at the moment at which the surfaces met, m/s. Bullet notices that up to a step later, and by
/// then gravity has gone on pulling: v^2 = v_now^2 - 2 g depth. Bullet moves bodies with the velocity that it
/// has just changed, so that the speed at the place where they are now is the mean of those before and after
/// this step's pull.
double speedOfTouch(double closing_m_s, double gravity_m_s2, double depth_m, double time_step_s);

/// How long ago surfaces met that close so fast and overlap by `depth_m`, s: no longer than a step. Below
/// zero where they are still apart, and 0 where they do not close.
double timeSinceTouch(double closing_m_s, double depth_m, double time_step_s);

/// When two points met or will, and how fast they close then.
struct TouchOfPoints {
    double ago_s = 0;      ///< as `timeSinceTouch` has it
    double speed_m_s = 0;  ///< as `speedOfTouch` has it; 0 where they pass without a touch
    bool is_bent = false;  ///< the bodies spin enough to matter
};

/// The two above for points of bodies that spin: a point goes round on a circle, and comes down to the ground
/// more slowly than it does a step before, or not at all. `normal`: the direction in which the first is
/// pushed.
TouchOfPoints touchOf(const PointMotion& pushed, const PointMotion& other, const btVector3& normal,
                      double depth_m, double time_step_s);

/// Closing speed of two points, m/s, up to which they rest on each other: two steps of free fall of one.
double slowestStrike(const PointMotion& a, const PointMotion& b, double time_step_s);

/// Whether a point of a body meets one of another that is several times as heavy, was apart from it a step
/// before, and is faster than a step of free fall would make it: such a one strikes, if it is slower than
/// `slowest_m_s` (slowestStrike), too. `closing_m_s` and `depth_m` as above.
bool isSetDown(const btCollisionObject& heavy, const btCollisionObject& body, double closing_m_s,
               double depth_m, double slowest_m_s, double time_step_s);

/// Between bodies that rest on each other, at most, m.
double largestRestingGap();

/// What of turns about its axes an app's angular factor leaves a body, in the frame that `frame_from_world`
/// leads to; none where it turns freely.
std::optional<Mat3> freeTurns(const btRigidBody& body, const btTransform& frame_from_world);

/// How an object gives way, in the frame that `frame_from_world` leads to. Of a multi-body's link only its
/// own mass counts, felt at `point` (world frame).
Mobility mobilityOf(const btCollisionObject& object, const btTransform& frame_from_world,
                    const btVector3& point);

/// Whether a body is dynamic and has a finite mass.
bool canMove(const btRigidBody& body);

/// Whether an object is a rigid body that can move.
bool givesWay(const btCollisionObject& object);

/// Whether gravity has had its way with a body: what rests, or has been let go just now, moves by less than
/// half of what a step of it gives.
bool falls(const btRigidBody& body, const btVector3& velocity, double time_step_s);

}  // namespace sherd
