// physics/detail/bounce.h: contacts that bounce in the step in which the bodies really meet.
//
// Bullet reports some contacts before they close: those of balls, capsules and cylinders from a gap of
// 2 cm on. Its solver then aims at the speed e v - gap/dt, where e is the restitution and v the closing
// speed. This is right for bodies that come to rest on a surface (e = 0). A bounce, however, would lose
// speed depending on the gap alone, and start up to (1 + e) v dt early.
//
// The gap is therefore changed before the solver runs. It becomes zero if the bodies meet within this
// step, and too wide to act if they do not. The bounce then has its full speed: the speed at the time
// of contact, less the effect of gravity until the end of the step. With the speed at the start of the
// step, a ball of restitution 1 gained 1.9 % of energy in a bounce at steps of 4 ms.
//
// In the step of a bounce Bullet moves the bodies apart for all of dt, although they first had to close
// the gap. This would make the next bounce higher. The bodies are therefore moved back by the part of
// the path for which there was no time.
#pragma once
#include "physics/detail/awake_world.h"

namespace thaum::physics::detail {

/// Bullet's world, with bounces that begin in the step in which the bodies really meet.
class BouncingWorld : public AwakeWorld {
public:
    using AwakeWorld::AwakeWorld;

    /// True: velocities are those at the ends of the steps, not half a step earlier as in Bullet.
    bool exact_flight{true};

protected:
    void solveConstraints(btContactSolverInfo&) override;
    void integrateTransforms(btScalar dt) override;

private:
    /// Part of the path on which Bullet moves a body after a bounce, for which there was no time in the step
    /// (m, world).
    struct UnusedPath {
        btRigidBody* body;
        btVector3 path;
    };
    /// Sets restitution and distance of the contacts of a pair that close faster than `min_speed` (m/s).
    void adjust_contact(btPersistentManifold&, btScalar dt, btScalar min_speed);
    void store_unused_path(const btCollisionObject&, const btVector3& path);

    btAlignedObjectArray<UnusedPath> unused_paths_;
};

}  // namespace thaum::physics::detail
