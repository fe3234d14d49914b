// physics/detail/bullet_world.h: Bullet as we set it up, so that physics.cpp reads without it.
#pragma once
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "physics/detail/bounce.h"
#include "physics/detail/cast.h"
#include "physics/detail/gather.h"
#include "physics/physics.h"

class btBvhTriangleMeshShape;

namespace thaum::physics::detail {

inline btVector3 to_bullet(vec3 v) { return {v.x, v.y, v.z}; }
inline vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// One mesh with its tree; shared by all bodies of that shape, never changed.
class Mesh {
public:
    explicit Mesh(const TriangleMesh&);
    ~Mesh();
    Mesh(Mesh&&) noexcept;
    Mesh& operator=(Mesh&&) noexcept;

    btCollisionShape* shape() const;
    /// Path in the mesh's frame.
    std::optional<CastHit> cast(const Path&) const;
    /// Its triangles within the radius of a point, all in the mesh's frame.
    void gather(vec3 point, double radius, const Nearby& body, NearestSurfaces&) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// A body outside any world.
struct BulletBody {
    std::unique_ptr<btCollisionShape> own_shape;  ///< empty for a mesh
    std::unique_ptr<btRigidBody> body;
};

BulletBody make_body(Key, const BodyDesc&, const BodyState&, const std::vector<Mesh>&, const Settings&);

/// Writes all of a state but its sleep.
void write_motion(btRigidBody&, const BodyState&);
/// Writes the sleep; must be the last thing done to a body, since most others wake it.
void write_sleep(btRigidBody&, const BodyState&);
BodyState read_state(const btRigidBody&);

inline Key key_of(const btCollisionObject& object) { return static_cast<Key>(object.getUserIndex()); }

/// Bullet's choice of collision algorithms but for cylinders. Elsewhere it finds one point of a contact in a step, which suffices
/// for what is round; a cylinder that lands flat would turn about that point and lose a fifth of its bounce.
class Algorithms : public btDefaultCollisionConfiguration {
public:
    explicit Algorithms(const btDefaultCollisionConstructionInfo&);
    btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type_a, int type_b) override;

private:
    btConvexConvexAlgorithm::CreateFunc several_points_;
};

/// Bullet's world and what it is made of. Bodies must outlive it.
class BulletWorld {
public:
    BT_DECLARE_ALIGNED_ALLOCATOR();  // from the pool, so that a rebuild asks the heap for nothing

    explicit BulletWorld(const Settings&);
    ~BulletWorld();

    btDiscreteDynamicsWorld& operator*() { return world_; }
    btDiscreteDynamicsWorld* operator->() { return &world_; }

private:
    // The order is that of use: each stands on those above it.
    Algorithms configuration_;
    btCollisionDispatcher dispatcher_;
    bt32BitAxisSweep3 broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    BouncingWorld world_;
};

}  // namespace thaum::physics::detail
