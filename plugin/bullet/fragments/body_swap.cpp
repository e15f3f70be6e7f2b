#include "bullet/fragments/body_swap.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "bullet/fragments/fragment_motion.h"
#include "bullet/world/anisotropic_friction.h"

namespace sherd {

namespace {

constexpr btScalar slow_surface =
    btScalar(0.5);  // of the linear threshold, at the surface of a piece at rest

/// The factors hold along the axes of a body, and a piece has axes of its own: those of the whole, seen along
/// them. Exact where the axes are parallel.
void inheritAnisotropicFriction(const btRigidBody& parent, btRigidBody& piece) {
    const int mode = anisotropicFrictionMode(parent);
    if (mode == btCollisionObject::CF_ANISOTROPIC_FRICTION_DISABLED) return;
    const btMatrix3x3 turn =
        parent.getWorldTransform().getBasis().transpose() * piece.getWorldTransform().getBasis();
    btVector3 factors;
    for (int axis = 0; axis < 3; ++axis) {
        const btVector3 along = turn.getColumn(axis);
        factors[axis] = (along * along).dot(parent.getAnisotropicFriction());
    }
    piece.setAnisotropicFriction(factors, mode);
}

void inheritSurface(const btRigidBody& parent, btRigidBody& piece) {
    piece.setFriction(parent.getFriction());
    piece.setRollingFriction(parent.getRollingFriction());
    piece.setSpinningFriction(parent.getSpinningFriction());
    piece.setRestitution(parent.getRestitution());
    const int surface_flags = btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING;
    if (parent.getCollisionFlags() & surface_flags)
        piece.setContactStiffnessAndDamping(parent.getContactStiffness(), parent.getContactDamping());
    piece.setContactProcessingThreshold(parent.getContactProcessingThreshold());
    const int is_static = btCollisionObject::CF_STATIC_OBJECT;  // each body's own
    piece.setCollisionFlags((parent.getCollisionFlags() & ~is_static) |
                            (piece.getCollisionFlags() & is_static));
    inheritAnisotropicFriction(parent, piece);
}

void inheritMotionRules(const btRigidBody& parent, const btVector3& world_gravity, btRigidBody& piece) {
    piece.setDamping(parent.getLinearDamping(), parent.getAngularDamping());
    piece.setFlags(parent.getFlags());
    // What the app held in its place would fly on as it was born, through everything.
    if (!parent.getLinearFactor().isZero()) {
        piece.setLinearFactor(parent.getLinearFactor());
        piece.setAngularFactor(parent.getAngularFactor());
    }
    piece.setGravity(parent.getInvMass() > 0 ? parent.getGravity() : world_gravity);
    piece.setCcdMotionThreshold(parent.getCcdMotionThreshold());
    btVector3 centre;
    btScalar radius;
    piece.getCollisionShape()->getBoundingSphere(centre, radius);
    piece.setCcdSweptSphereRadius(std::min(parent.getCcdSweptSphereRadius(), radius));
    // Bullet's angular threshold suits bodies of about a metre. Contacts come and go while a small piece
    // rocks on them, so that it never stops; a part of the linear threshold at its surface counts as rest.
    const btScalar slow_turn = slow_surface * parent.getLinearSleepingThreshold() / radius;
    piece.setSleepingThresholds(parent.getLinearSleepingThreshold(),
                                std::max(parent.getAngularSleepingThreshold(), slow_turn));
}

void inheritAppData(btRigidBody& parent, btRigidBody& piece) {
    piece.setUserPointer(parent.getUserPointer());
    piece.setUserIndex(parent.getUserIndex());
    piece.setUserIndex2(parent.getUserIndex2());
    piece.setUserIndex3(parent.getUserIndex3());
    btVector3 colour;
    if (parent.getCustomDebugColor(colour)) piece.setCustomDebugColor(colour);
}

/// The app's own filter; where it left the choice to Bullet, what Bullet chooses for the piece.
CollisionFilter inheritedFilter(const btRigidBody& parent, const btRigidBody& piece) {
    const btBroadphaseProxy* proxy = parent.getBroadphaseHandle();
    const CollisionFilter usual = CollisionFilter::usual(piece.isStaticObject());
    if (!proxy) return usual;
    const CollisionFilter given{proxy->m_collisionFilterGroup, proxy->m_collisionFilterMask};
    return given == CollisionFilter::usual(parent.isStaticObject()) ? usual : given;
}

bool isHeld(const std::unique_ptr<Breakable>& piece) {
    return piece->body->isStaticObject();
}

/// The one axis about which factors let a body turn; none if it turns about more or none.
std::optional<btVector3> freeAxis(const btRigidBody& body) {
    const btVector3& factor = body.getAngularFactor();
    const btVector3 axis(factor.x() != 0, factor.y() != 0, factor.z() != 0);
    return axis.length2() == 1 ? std::optional<btVector3>(axis) : std::nullopt;
}

/// What `turnAboutOneAxis` took from a fragment, whose momentum its pieces are to have.
void restoreInertia(const Breakable& fragment, double mass_scale) {
    const BreakableSolid& solid = *fragment.asset.solid();
    const Vec3 inertia =
        mass_scale * solid.material().density_kg_m3 * principalFrame(solid.moments()).inertia;
    const Vec3 inverse = inertia.cwiseInverse();
    fragment.body->setInvInertiaDiagLocal(
        btVector3(btScalar(inverse.x()), btScalar(inverse.y()), btScalar(inverse.z())));
    fragment.body->updateInertiaTensor();
}

}  // namespace

void turnAboutOneAxis(btRigidBody& body) {
    const std::optional<btVector3> axis = freeAxis(body);
    if (!axis || !(body.getInvMass() > 0)) return;
    const btVector3 own = *axis * body.getWorldTransform().getBasis();
    const btScalar inverse = 1 / (own * own).dot(body.getLocalInertia());
    body.setInvInertiaDiagLocal(btVector3(inverse, inverse, inverse));
    body.updateInertiaTensor();
}

std::vector<std::unique_ptr<Breakable>> makeFragmentBodies(const Breakable& parent,
                                                           const DecidedBlow& decided,
                                                           const btVector3& world_gravity, bool inside_step) {
    btRigidBody& whole = *parent.body;
    const bool was_static = whole.getInvMass() == 0;
    const double mass_scale = was_static ? 1 : 1 / (whole.getInvMass() * parent.asset.mass());
    if (parent.isFragment() && !was_static && freeAxis(whole)) restoreInertia(parent, mass_scale);
    const btTransform world_from_asset = parent.placed(whole.getWorldTransform());
    const btTransform drawn_from_asset = parent.placed(renderedTransform(whole));
    std::vector<std::unique_ptr<Breakable>> pieces;
    std::vector<btRigidBody*> moving;
    const std::vector<Fragment>& fragments = decided.outcome.fragments;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const BreakableSolid& solid = *fragments[i].solid;
        auto piece = std::make_unique<Breakable>(BreakableAsset(fragments[i].solid), parent.fracture);
        piece->owned = makeRigidBody(solid, decided.shapes.at(i), solid.isAnchored() ? 0 : mass_scale);
        piece->body = piece->owned.body.get();
        piece->body_from_asset = principalFrame(solid.moments()).body_from_asset;
        const btTransform asset_from_body = piece->body_from_asset.inverse();
        placeBody(piece->owned, world_from_asset * asset_from_body, drawn_from_asset * asset_from_body,
                  piece->body_from_asset);
        piece->inner_ball = innerBall(*piece->owned.shape->shape);
        piece->name = parent.name;
        piece->filter = inheritedFilter(whole, *piece->body);
        inheritSurface(whole, *piece->body);
        inheritMotionRules(whole, world_gravity, *piece->body);
        inheritAppData(whole, *piece->body);
        if (!isHeld(piece)) moving.push_back(piece->body);
        pieces.push_back(std::move(piece));
    }
    if (was_static) {
        for (btRigidBody* piece : moving)
            if (inside_step) piece->applyGravity();
    } else if (moving.size() < pieces.size()) {
        followMotion(whole, moving);
        shareForces(whole, moving, inside_step);
    } else {
        shareMotion(whole, moving);
        shareForces(whole, moving, inside_step);
    }
    return pieces;
}

double momentumError(const btRigidBody& parent, const std::vector<std::unique_ptr<Breakable>>& fragments) {
    if (parent.isStaticObject() || std::any_of(fragments.begin(), fragments.end(), isHeld)) return 0;
    std::vector<const btRigidBody*> bodies;
    for (const auto& fragment : fragments) bodies.push_back(fragment->body);
    return momentumDifference(parent, bodies);
}

double dropDebris(const std::vector<Fragment>& fragments, std::vector<std::unique_ptr<Breakable>>& pieces) {
    double mass = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!fragments[i].dropped) continue;
        const double inverse_mass = pieces[i]->body->getInvMass();
        mass += inverse_mass > 0 ? 1 / inverse_mass : pieces[i]->asset.mass();
        pieces[i].reset();
    }
    pieces.erase(std::remove(pieces.begin(), pieces.end(), nullptr), pieces.end());
    return mass;
}

void addToWorld(btDiscreteDynamicsWorld& world, const std::vector<Breakable*>& fragments,
                btScalar time_step_s) {
    for (const Breakable* fragment : fragments) {
        btRigidBody& body = *fragment->body;
        const btVector3 own_gravity = body.getGravity();
        world.addRigidBody(&body, fragment->filter.group, fragment->filter.mask);
        body.setGravity(own_gravity);  // adding a body sets it to the world's
        // Adding a body sets its bounds without the margin for contacts and without its motion in this step.
        body.predictIntegratedTransform(time_step_s, body.getInterpolationWorldTransform());
        world.updateSingleAabb(&body);
    }
}

void findContactsOf(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& new_bodies) {
    const auto* tree = dynamic_cast<const btDbvtBroadphase*>(world.getBroadphase());
    if (!tree || tree->m_deferedcollide)
        world.getBroadphase()->calculateOverlappingPairs(world.getDispatcher());
    auto* dispatcher = dynamic_cast<btCollisionDispatcher*>(world.getDispatcher());
    if (!dispatcher) {
        world.getDispatcher()->dispatchAllCollisionPairs(world.getPairCache(), world.getDispatchInfo(),
                                                         world.getDispatcher());
        return;
    }
    // The order of Bullet's pairs follows a tree that it sorts by addresses. That of the numbers that bodies
    // have in the broadphase does not, and the order of contacts decides how a solve comes out.
    using Proxies = std::pair<btBroadphaseProxy*, btBroadphaseProxy*>;
    std::vector<Proxies> concerned;
    const std::unordered_set<const void*> is_new(new_bodies.begin(), new_bodies.end());
    const btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
    for (int i = 0; i < pairs.size(); ++i)
        if (is_new.count(pairs[i].m_pProxy0->m_clientObject) ||
            is_new.count(pairs[i].m_pProxy1->m_clientObject))
            concerned.emplace_back(pairs[i].m_pProxy0, pairs[i].m_pProxy1);
    std::sort(concerned.begin(), concerned.end(), [](const Proxies& a, const Proxies& b) {
        return std::make_pair(a.first->m_uniqueId, a.second->m_uniqueId) <
               std::make_pair(b.first->m_uniqueId, b.second->m_uniqueId);
    });
    for (const Proxies& proxies : concerned)
        if (btBroadphasePair* pair = world.getPairCache()->findPair(proxies.first, proxies.second))
            dispatcher->getNearCallback()(*pair, *dispatcher, world.getDispatchInfo());
}

}  // namespace sherd
