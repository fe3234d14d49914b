// physics/detail/bounce.h: contacts that bounce, in the step in which the bodies really meet.
//
// Bullet reports some contacts before they close: those of balls, capsules and cylinders from 2 cm on, with the gap
// that is left. Its solver then wants the speed e v - gap/dt, where e is the restitution and v the closing speed: right
// for what should come to rest on a surface (e = 0), but a bounce loses a part that depends on the gap alone, and
// begins up to (1 + e) v dt early. So the solver is given another gap: none where the two meet within this step, and
// one too wide to act on where they do not. The bounce then has its whole speed: that at the time of contact, less what
// gravity takes until the step's end. With the speed at the step's start a ball of restitution 1 gained 1.9 % of its
// energy a bounce at steps of 4 ms.
//
// In the step of a bounce Bullet moves the bodies apart for the whole of dt, although they first had to close the gap. Each such
// step would raise the next bounce; so the bodies are put back by the way that they had no time for.
#pragma once
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

namespace thaum::physics::detail {

class BouncingWorld : public btDiscreteDynamicsWorld {
public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

    /// Velocities are those at the ends of the steps, not half a step earlier as in Bullet.
    bool exact_flight{true};

protected:
    void solveConstraints(btContactSolverInfo&) override;
    void integrateTransforms(btScalar dt) override;

private:
    /// Way that a body had no time for (m, world).
    struct UnusedPath {
        btRigidBody* body;
        btVector3 way;
    };
    void time_contact(btPersistentManifold&, btScalar dt, btScalar least_speed);
    void put_back(const btCollisionObject&, const btVector3& way);

    btAlignedObjectArray<UnusedPath> unused_paths_;
};

}  // namespace thaum::physics::detail
