#include "bullet/world/body_checks.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "bullet/world/conversions.h"

namespace sherd {

Status checkOptions(const BodyOptions& options) {
    constexpr double rigid = 1e-3;
    constexpr btScalar furthest_m = 1e7f;
    const Mat3 turn = fromBullet(options.start.getBasis());
    if (!isFinite(options.start.getOrigin())) return Error{"the start is not finite; give its place in m"};
    if (!((turn * turn.transpose() - Mat3::Identity()).norm() < rigid) || turn.determinant() < 0)
        return Error{
            "the start is not a rotation and a translation (its matrix scales, mirrors or is not finite); "
            "scale the mesh instead"};
    if (!(options.start.getOrigin().length() <= furthest_m))
        return Error{
            "the start is further than 10,000 km from the origin, where a float tells metres apart at best; "
            "give it in m, or put the origin near to what happens"};
    if (!isFinite(options.velocity)) return Error{"the velocity is not finite; give it in m/s"};
    if (!isFinite(options.angular_velocity))
        return Error{"the angular velocity is not finite; give it in rad/s"};
    if (!(options.velocity.length() < speed_of_light_m_s))
        return Error{"the velocity is faster than light; give it in m/s"};
    return options.fracture ? options.fracture->validate() : success();
}

Status checkWorld(const btDiscreteDynamicsWorld& world) {
    if (world.getWorldType() == BT_DEFORMABLE_MULTIBODY_DYNAMICS_WORLD)
        return Error{
            "bodies cannot break in a btDeformableMultiBodyDynamicsWorld, since it does not tell its "
            "constraint solver when a solve begins; use a btSoftRigidDynamicsWorld or a "
            "btMultiBodyDynamicsWorld"};
    return success();
}

}  // namespace sherd
