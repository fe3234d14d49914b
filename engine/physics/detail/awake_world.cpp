#include "physics/detail/awake_world.h"

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

namespace thaum::physics::detail {
namespace {

/// Values of a body's second user index, which Bullet itself does not use.
constexpr int bounds_unknown = -1;  // the bounds must be computed; also Bullet's initial value
constexpr int bounds_at_rest = 1;   // the bounds were computed at rest and remain valid

bool needs_bounds(const btCollisionObject& object) {
    return object.isActive() || object.getUserIndex2() != bounds_at_rest;
}

bool awake(const btBroadphasePair& pair) {
    return static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject)->isActive() ||
           static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject)->isActive();
}

/// The order in which Bullet visits pairs with m_deterministicOverlappingPairs.
struct BulletsOrder {
    bool operator()(const btBroadphasePair* a, const btBroadphasePair* b) const {
        const int a0 = a->m_pProxy0->m_uniqueId, b0 = b->m_pProxy0->m_uniqueId;
        return a0 > b0 || (a0 == b0 && a->m_pProxy1->m_uniqueId > b->m_pProxy1->m_uniqueId);
    }
};

}  // namespace

void forget_bounds(btCollisionObject& object) { object.setUserIndex2(bounds_unknown); }

void AwakeDispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                                btDispatcher*) {
    awake_pairs_.resizeNoInitialize(0);
    btBroadphasePairArray& all = pairs->getOverlappingPairArray();
    for (int i = 0; i < all.size(); ++i) {
        if (awake(all[i])) awake_pairs_.push_back(&all[i]);
    }
    awake_pairs_.quickSort(BulletsOrder());
    for (int i = 0; i < awake_pairs_.size(); ++i) getNearCallback()(*awake_pairs_[i], *this, info);
}

/// The bounds of a body contain its predicted place, too. Bullet stops a body only at the end of the step in
/// which it falls asleep, so the bounds of a sleeping body are final one step later.
void AwakeWorld::updateAabbs() {
    for (int i = 0; i < m_collisionObjects.size(); ++i) {
        btCollisionObject& object = *m_collisionObjects[i];
        if (!needs_bounds(object)) continue;
        updateSingleAabb(&object);
        object.setUserIndex2(object.isActive() ? bounds_unknown : bounds_at_rest);
    }
}

void AwakeWorld::predictUnconstraintMotion(btScalar dt) {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& body = *m_nonStaticRigidBodies[i];
        if (needs_bounds(body)) body.predictIntegratedTransform(dt, body.getInterpolationWorldTransform());
    }
}

}  // namespace thaum::physics::detail
