// physics/detail/awake_world.h: Bullet's world and dispatcher, without the work on bodies at rest.
//
// In each step Bullet recomputes the bounding boxes of all bodies, predicts the motion of all dynamic bodies,
// and looks at all pairs of overlapping boxes, most of which are of a static and a sleeping body. Here a step
// visits only what can have changed: awake bodies, and others once after they were added, moved or fell
// asleep. Every result has the same bits as in Bullet's own step.
#pragma once
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

namespace thaum::physics::detail {

/// Tells the world that a body was moved from outside, so that its bounding box is computed again.
void forget_bounds(btCollisionObject&);

/// Finds contacts of those overlapping pairs of which a body is awake.
class AwakeDispatcher : public btCollisionDispatcher {
public:
    using btCollisionDispatcher::btCollisionDispatcher;
    void dispatchAllCollisionPairs(btOverlappingPairCache*, const btDispatcherInfo&, btDispatcher*) override;

private:
    btAlignedObjectArray<btBroadphasePair*> awake_pairs_;
};

/// Bullet's world for bodies without damping, continuous collision, kinematic bodies and motion states, which
/// physics.cpp does not use or does itself.
class AwakeWorld : public btDiscreteDynamicsWorld {
public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

    void updateAabbs() override;
    void synchronizeMotionStates() override {}

protected:
    void predictUnconstraintMotion(btScalar dt) override;
    void createPredictiveContacts(btScalar) override {}
    void saveKinematicState(btScalar) override {}
};

}  // namespace thaum::physics::detail
