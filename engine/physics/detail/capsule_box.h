// physics/detail/capsule_box.h: contact of an upright capsule (a person) and a box, in closed form.
//
// Bullet finds the nearest points of all convex shapes by one iteration (GJK), at 9,000 instructions for a
// person on a floor. Along a capsule's axis, however, the distance from a box is convex, and its derivative
// is linear in pieces: the nearest point follows from at most eight values of the derivative. The geometry is
// that of Bullet: a segment and a box without its margin, both grown by round margins.
#pragma once
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>

#include "core/maths.h"

namespace thaum::physics::detail {

/// Nearest points of a segment and a box around the origin.
struct SegmentToBox {
    vec3 on_segment, on_box;
};

/// The nearest points of the box and the segment from `centre` - `half_axis` to `centre` + `half_axis`, all
/// in the frame of the box. If a whole part of the segment is equally near, its middle is returned.
SegmentToBox nearest_points(vec3 centre, vec3 half_axis, vec3 box_half);

/// Finds the contact of a capsule and a box. If the capsule can rotate, or its axis is inside the box,
/// Bullet's own algorithm is used instead.
class CapsuleBoxAlgorithm : public btConvexConvexAlgorithm {
public:
    CapsuleBoxAlgorithm(const btCollisionAlgorithmConstructionInfo&, const btCollisionObjectWrapper* a,
                        const btCollisionObjectWrapper* b,
                        const btConvexConvexAlgorithm::CreateFunc& settings);
    CapsuleBoxAlgorithm(const CapsuleBoxAlgorithm&) = delete;
    CapsuleBoxAlgorithm& operator=(const CapsuleBoxAlgorithm&) = delete;
    ~CapsuleBoxAlgorithm() override;

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo&, btManifoldResult*) override;
    void getAllContactManifolds(btManifoldArray&) override;

    /// Makes the algorithm. Its settings are those of Bullet's own one.
    struct CreateFunc : btConvexConvexAlgorithm::CreateFunc {
        using btConvexConvexAlgorithm::CreateFunc::CreateFunc;
        btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo&,
                                                       const btCollisionObjectWrapper* a,
                                                       const btCollisionObjectWrapper* b) override;
    };

private:
    btPersistentManifold* own_contacts_;  ///< null if the caller gave the manifold
};

}  // namespace thaum::physics::detail
