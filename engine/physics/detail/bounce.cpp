#include "physics/detail/bounce.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>

namespace thaum::physics::detail {
namespace {

/// Closing speed of two surfaces in contact; negative if they separate (m/s).
struct ClosingSpeeds {
    btScalar start;  ///< speed before the forces of this step; the solver applies restitution to it
    btScalar end;    ///< speed after the forces of this step; decides whether the surfaces meet
};

btVector3 velocity_at(const btRigidBody* body, const btVector3& point) {
    return body == nullptr ? btVector3(0, 0, 0)
                           : body->getVelocityInLocalPoint(point - body->getCenterOfMassPosition());
}

btVector3 velocity_by_forces(const btRigidBody* body, btScalar dt) {
    return body == nullptr ? btVector3(0, 0, 0) : body->getTotalForce() * (body->getInvMass() * dt);
}

ClosingSpeeds closing_at(const btManifoldPoint& point, const btRigidBody* a, const btRigidBody* b,
                         btScalar dt) {
    const btVector3 apart =
        velocity_at(a, point.getPositionWorldOnA()) - velocity_at(b, point.getPositionWorldOnB());
    const btVector3 gained = velocity_by_forces(a, dt) - velocity_by_forces(b, dt);
    const btScalar start = -point.m_normalWorldOnB.dot(apart);
    return {start, start - point.m_normalWorldOnB.dot(gained)};
}

/// Speed at which two bodies separate at the end of the step in which they bounce (m/s). They bounce with
/// their speed at the time of contact. At the start of the step they are `gap` apart, or -gap inside each
/// other; `e` is the restitution. While they move apart, their acceleration acts as in free flight.
/// Penetration adds no speed, because it is removed from the positions alone; `taken_out` is the share of it
/// that this step removes.
btScalar rebound(const ClosingSpeeds& closing, btScalar gap, btScalar e, btScalar dt, btScalar taken_out) {
    const btScalar gained = closing.end - closing.start, acceleration = gained / dt;
    // Square of the closing speed at the time of contact.
    const btScalar at_contact = closing.start * closing.start + 2 * acceleration * gap;
    const btScalar speed = e * std::sqrt(std::max(btScalar(0), at_contact));
    // Distance of the bodies after dt, except for the part `speed * dt` by which they then move apart.
    const btScalar start = gap > 0 ? -e * gap : (1 - taken_out) * gap;
    if (start + speed * dt <= 0) return speed;
    // The speed v at the end of the step solves v^2 = speed^2 - 2 acceleration (start + v dt).
    const btScalar root = gained * gained + speed * speed - 2 * acceleration * start;
    return std::max(btScalar(0), std::sqrt(std::max(btScalar(0), root)) - gained);
}

}  // namespace

void BouncingWorld::adjust_contact(btPersistentManifold& manifold, btScalar dt, btScalar min_speed) {
    const btRigidBody* const a = btRigidBody::upcast(manifold.getBody0());
    const btRigidBody* const b = btRigidBody::upcast(manifold.getBody1());
    const btScalar e = manifold.getBody0()->getRestitution() * manifold.getBody1()->getRestitution();
    btScalar most = 0;
    btVector3 normal(0, 0, 0);
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& point = manifold.getContactPoint(i);
        const btScalar gap = point.getDistance();
        point.m_combinedRestitution = e;
        const ClosingSpeeds closing = closing_at(point, a, b, dt);
        // The bodies close too slowly to bounce, and the solver lets them come to rest.
        if (closing.start < min_speed) continue;
        if (exact_flight && gap < closing.end * dt)
            point.m_combinedRestitution =
                rebound(closing, gap, e, dt, getSolverInfo().m_erp2) / closing.start;
        if (gap <= 0) continue;
        if (gap >= closing.end * dt) {
            point.setDistance(std::max(gap, (e * closing.start + closing.end) * dt));
            continue;
        }
        point.setDistance(0);
        if ((1 + e) * gap > most) most = (1 + e) * gap, normal = point.m_normalWorldOnB;
    }
    if (most <= 0) return;
    const btScalar give_a = a ? a->getInvMass() : 0, give_b = b ? b->getInvMass() : 0;
    store_unused_path(*manifold.getBody0(), normal * (-most * give_a / (give_a + give_b)));
    store_unused_path(*manifold.getBody1(), normal * (most * give_b / (give_a + give_b)));
}

/// Stores the part of a body's path by which it must be moved back after a bounce, since there was no time
/// for it. Two adjacent floors may both request the same part, so only what exceeds the stored part in that
/// direction is added.
void BouncingWorld::store_unused_path(const btCollisionObject& object, const btVector3& path) {
    const btScalar length = path.length();
    if (length <= 0) return;
    auto* const body = const_cast<btRigidBody*>(btRigidBody::upcast(&object));
    const btVector3 direction = path / length;
    for (int i = 0; i < unused_paths_.size(); ++i) {
        UnusedPath& known = unused_paths_[i];
        if (known.body != body) continue;
        known.path += direction * std::max(btScalar(0), length - known.path.dot(direction));
        return;
    }
    unused_paths_.push_back({body, path});
}

void BouncingWorld::solveConstraints(btContactSolverInfo& info) {
    unused_paths_.resizeNoInitialize(0);
    btDispatcher& dispatcher = *getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() == 0 ||
            manifold.getBody0()->getRestitution() * manifold.getBody1()->getRestitution() <= 0)
            continue;
        adjust_contact(manifold, info.m_timeStep, info.m_restitutionVelocityThreshold);
    }
    AwakeWorld::solveConstraints(info);
}

void BouncingWorld::integrateTransforms(btScalar dt) {
    AwakeWorld::integrateTransforms(dt);
    for (int i = 0; i < unused_paths_.size(); ++i) {
        btTransform& place = unused_paths_[i].body->getWorldTransform();
        place.setOrigin(place.getOrigin() + unused_paths_[i].path);
    }
}

}  // namespace thaum::physics::detail
