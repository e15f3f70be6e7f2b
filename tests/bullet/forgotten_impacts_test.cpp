// What the solver begins a step with after pieces have struck something.

#include <algorithm>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// Notes the largest impulse that a solve begins with, in weights of both bodies of a contact in a step.
struct WatchingSolver : btSequentialImpulseConstraintSolver {
    btScalar solveGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                        int count, btTypedConstraint** constraints, int constraint_count,
                        const btContactSolverInfo& info, btIDebugDraw* drawer,
                        btDispatcher* dispatcher) override {
        for (int m = 0; m < count; ++m) {
            btScalar weight = 0;
            for (const btCollisionObject* object : {manifolds[m]->getBody0(), manifolds[m]->getBody1()}) {
                const btScalar inverse_mass = btRigidBody::upcast(object)->getInvMass();
                if (inverse_mass > 0) weight += btScalar(9.81) / inverse_mass;
            }
            for (int p = 0; p < manifolds[m]->getNumContacts(); ++p)
                most = std::max(
                    most, manifolds[m]->getContactPoint(p).m_appliedImpulse / (weight * info.m_timeStep));
        }
        return btSequentialImpulseConstraintSolver::solveGroup(
            bodies, body_count, manifolds, count, constraints, constraint_count, info, drawer, dispatcher);
    }
    btScalar most = 0;
};

TEST(Impacts, AreNotWhatTheNextStepBeginsWith) {
    WatchingSolver solver;
    TestWorld scene;
    scene.world->setConstraintSolver(&solver);
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    Settings settings = coarse(0.06);
    settings.fracture.largest_generation = 1;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    BodyOptions options(at(0, 0, 0.05f));
    options.velocity = btVector3(0, 0, -4);
    ASSERT_TRUE(fracture.add(asset.value(), options).ok());
    ASSERT_EQ(stepUntilBreak(scene, fracture).outcome, Outcome::broke);
    solver.most = 0;
    scene.step(60);
    EXPECT_LE(solver.most, 10.01f);
    EXPECT_GT(solver.most, 0) << "resting contacts are begun with";
}

}  // namespace
