// physics/detail/bullet_world.h: Bullet's world, bodies and meshes with our choice of options.
#pragma once
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "physics/detail/awake_world.h"
#include "physics/detail/bounce.h"
#include "physics/detail/capsule_box.h"
#include "physics/detail/cast.h"
#include "physics/detail/gather.h"
#include "physics/physics.h"

class btBvhTriangleMeshShape;

namespace thaum::physics::detail {

inline btVector3 to_bullet(vec3 v) { return {v.x, v.y, v.z}; }
inline vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// A mesh with its search tree. All bodies of that shape share it, and it never changes.
class Mesh {
public:
    explicit Mesh(const TriangleMesh&);
    ~Mesh();
    Mesh(Mesh&&) noexcept;
    Mesh& operator=(Mesh&&) noexcept;

    btCollisionShape* shape() const;
    /// Casts a path given in the frame of the mesh.
    std::optional<CastHit> cast(const Path&) const;
    /// Adds the triangles within the reach of the search around a point, all in the frame of the mesh.
    void gather(vec3 point, const Nearby& body, NearestSurfaces&) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// A body that is not yet in a world.
struct BulletBody {
    std::unique_ptr<btCollisionShape> own_shape;  ///< shape that belongs to this body alone; null for a mesh
    std::unique_ptr<btRigidBody> body;
};

BulletBody make_body(Key, const BodyDesc&, const BodyState&, const std::vector<Mesh>&, const Settings&);

/// Writes a state to Bullet's body, except for the members about sleep.
void write_motion(btRigidBody&, const BodyState&);
/// Writes the members about sleep to Bullet's body. This must be the last change of a body, because most
/// other changes wake it.
void write_sleep(btRigidBody&, const BodyState&);
BodyState read_state(const btRigidBody&);

inline Key key_of(const btCollisionObject& object) { return static_cast<Key>(object.getUserIndex()); }

/// Bullet's default collision algorithms, except for cylinders and persons on boxes. By default Bullet finds
/// one new contact point in each step, which is enough for round shapes. A cylinder that lands flat would
/// turn about that point and lose a fifth of its bounce.
class Algorithms : public btDefaultCollisionConfiguration {
public:
    explicit Algorithms(const btDefaultCollisionConstructionInfo&);
    btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type_a, int type_b) override;

private:
    btConvexConvexAlgorithm::CreateFunc several_points_;
    CapsuleBoxAlgorithm::CreateFunc capsule_box_;
};

/// Bullet's world and its parts. Bodies must outlive this object.
class BulletWorld {
public:
    // Allocates this class from the pool, so that a rebuild does not allocate from the heap.
    BT_DECLARE_ALIGNED_ALLOCATOR();

    explicit BulletWorld(const Settings&);
    ~BulletWorld();

    btDiscreteDynamicsWorld& operator*() { return world_; }
    btDiscreteDynamicsWorld* operator->() { return &world_; }

private:
    // Each member uses those above it, so the order matters.
    Algorithms configuration_;
    AwakeDispatcher dispatcher_;
    bt32BitAxisSweep3 broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    BouncingWorld world_;
};

}  // namespace thaum::physics::detail
