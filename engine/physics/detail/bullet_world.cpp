// Options of Bullet, with the reasons:
// - Sweep and prune, because its set of pairs depends only on the current positions. The usual tree
//   (Dbvt) reorganises itself a little in each step, so a skipped step would change later ones.
// - Deterministic pairs: the order of the solver's rows then does not depend on when a pair first met.
// - Split impulses always remove penetration. At 1 kHz Bullet's default turns a penetration of 1 cm
//   into a bounce of 2 m/s.
// - Damping is computed in physics.cpp, exactly for any time step.
// - A step starts from all of the last step's impulses. Bullet keeps 85 %, so its ten iterations must
//   find the rest again in each step. That failed for 200 kg on four bodies of 2 kg: they sank into
//   each other and fell within a second.
// - The solver ends for an island (bodies that touch one another) when it has settled to a tenth of a
//   nanometre per second. Bullet goes on until no bit of any island changes, which most never reach.
// - Bullet rounds the edges of a box by its margin. Between two static boxes that form one floor this
//   leaves a groove. At the default margin of 4 cm a rolling ball hops 5 mm there, at 1 mm only 0.14
//   mm.
#include "physics/detail/bullet_world.h"

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>

#include <algorithm>

#include "core/assert.h"
#include "physics/detail/triangle_tree.h"

namespace thaum::physics::detail {
namespace {

constexpr double settled_speed = 1e-10;      // largest change of speed in the solver's last iteration (m/s)
constexpr double static_box_margin = 0.001;  // largest collision margin of a static box (m)

/// Bullet's own correction for contacts on meshes: at edges within a flat surface it replaces the contact's
/// normal by that of the triangle.
bool smooth_inner_edge(btManifoldPoint& point, const btCollisionObjectWrapper* a, int part_a, int index_a,
                       const btCollisionObjectWrapper* b, int part_b, int index_b) {
    btAdjustInternalEdgeContacts(point, b, a, part_b, index_b);
    btAdjustInternalEdgeContacts(point, a, b, part_a, index_a);
    return true;
}

void hook_contacts() {
    static const bool hooked = [] {
        gContactAddedCallback = smooth_inner_edge;
        return true;
    }();
    static_cast<void>(hooked);
}

std::unique_ptr<btCollisionShape> make_shape(const BodyDesc& desc) {
    switch (desc.shape) {
        case Shape::box: {
            auto box = std::make_unique<btBoxShape>(to_bullet(desc.size));
            if (desc.mass == 0) box->setMargin(std::min(box->getMargin(), btScalar(static_box_margin)));
            return box;
        }
        case Shape::sphere: return std::make_unique<btSphereShape>(desc.size.x);
        case Shape::capsule: return std::make_unique<btCapsuleShape>(desc.size.x, 2 * desc.size.y);
        case Shape::cylinder:
            return std::make_unique<btCylinderShape>(btVector3(desc.size.x, desc.size.y, desc.size.x));
        case Shape::mesh: break;
    }
    return nullptr;
}

btTransform transform_of(const BodyState& state) {
    const quat q = state.orientation;
    return btTransform(btQuaternion(q.x, q.y, q.z, q.w), to_bullet(state.position));
}

/// Excludes pairs of static bodies, which Bullet would otherwise keep.
struct NoStaticPairs : btOverlapFilterCallback {
    bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
        const auto* body_a = static_cast<const btCollisionObject*>(a->m_clientObject);
        const auto* body_b = static_cast<const btCollisionObject*>(b->m_clientObject);
        if (body_a->isStaticObject() && body_b->isStaticObject()) return false;
        return (a->m_collisionFilterGroup & b->m_collisionFilterMask) != 0 &&
               (b->m_collisionFilterGroup & a->m_collisionFilterMask) != 0;
    }
};

NoStaticPairs& no_static_pairs() {
    static NoStaticPairs filter;
    return filter;
}

btDefaultCollisionConstructionInfo pools_for(const Settings& settings) {
    btDefaultCollisionConstructionInfo info;
    // Initial sizes. Beyond them, Bullet allocates single blocks from our pool.
    const int pairs = static_cast<int>(std::min(settings.max_bodies, 256U)) * 4;
    info.m_defaultMaxPersistentManifoldPoolSize = pairs;
    info.m_defaultMaxCollisionAlgorithmPoolSize = pairs;
    info.m_customCollisionAlgorithmMaxElementSize = sizeof(CapsuleBoxAlgorithm);
    return info;
}

}  // namespace

struct Mesh::Parts {
    std::vector<int> indices;
    std::vector<btVector3> vertices;
    std::unique_ptr<btTriangleIndexVertexArray> triangles;
    std::unique_ptr<btBvhTriangleMeshShape> shape;
    std::unique_ptr<btTriangleInfoMap> edges;
    TriangleTree tree;
};

namespace {

/// The triangles of a mesh in the order of Bullet's tree, which keeps near ones together.
std::vector<std::uint32_t> tree_order(const btBvhTriangleMeshShape& shape) {
    struct Collect : btTriangleCallback {
        std::vector<std::uint32_t> order;
        void processTriangle(btVector3*, int, int index) override {
            order.push_back(static_cast<std::uint32_t>(index));
        }
    } all;
    shape.processAllTriangles(&all, shape.getLocalAabbMin(), shape.getLocalAabbMax());
    return all.order;
}

}  // namespace

Mesh::Mesh(const TriangleMesh& mesh) : parts_(std::make_unique<Parts>()) {
    THAUM_ASSERT(!mesh.triangles.empty(), "a mesh has no triangles");
    hook_contacts();
    Parts& p = *parts_;
    for (const vec3& v : mesh.vertices) {
        THAUM_ASSERT(is_finite(v), "a vertex of a mesh is not finite");
        p.vertices.push_back(to_bullet(v));
    }
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle) {
            THAUM_ASSERT(index < mesh.vertices.size(),
                         "a triangle of a mesh has an index beyond the vertices");
            p.indices.push_back(static_cast<int>(index));
        }
    }
    p.triangles = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(mesh.triangles.size()), p.indices.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(p.vertices.size()), reinterpret_cast<btScalar*>(p.vertices.data()),
        static_cast<int>(sizeof(btVector3)));
    p.shape = std::make_unique<btBvhTriangleMeshShape>(p.triangles.get(), true);
    p.edges = std::make_unique<btTriangleInfoMap>();
    btGenerateInternalEdgeInfo(p.shape.get(), p.edges.get());
    p.tree = TriangleTree(mesh, tree_order(*p.shape));
}

Mesh::~Mesh() = default;
Mesh::Mesh(Mesh&&) noexcept = default;
Mesh& Mesh::operator=(Mesh&&) noexcept = default;

btCollisionShape* Mesh::shape() const { return parts_->shape.get(); }

std::optional<CastHit> Mesh::cast(const Path& path) const {
    struct NearestHit : btTriangleCallback {
        Path path;
        std::optional<CastHit> contact;
        void processTriangle(btVector3* corner, int, int) override {
            const vec3 corners[3] = {from_bullet(corner[0]), from_bullet(corner[1]), from_bullet(corner[2])};
            const auto here = detail::cast(path, [&](vec3 p) { return nearest_to_triangle(corners, p); });
            if (here && (!contact || here->travelled < contact->travelled)) contact = here;
        }
    } nearest;
    nearest.path = path;
    // Bullet's tree only selects the triangles, which `cast` then tests exactly. A box slightly larger than
    // the sphere covers the tree's own rounding.
    const double reach = path.radius + 1e-3;
    const btVector3 from = to_bullet(path.from);
    const btVector3 to = to_bullet(path.from + path.length * path.direction);
    const btVector3 half(reach, reach, reach);
    parts_->shape->performConvexcast(&nearest, from, to, -half, half);
    return nearest.contact;
}

void Mesh::gather(vec3 point, const Nearby& body, NearestSurfaces& into) const {
    parts_->tree.gather(point, body, into);
}

void write_motion(btRigidBody& body, const BodyState& state) {
    body.setCenterOfMassTransform(transform_of(state));
    body.setLinearVelocity(to_bullet(state.velocity));
    body.setAngularVelocity(to_bullet(state.spin));
    body.setInterpolationLinearVelocity(body.getLinearVelocity());
    body.setInterpolationAngularVelocity(body.getAngularVelocity());
    forget_bounds(body);
}

void write_sleep(btRigidBody& body, const BodyState& state) {
    body.setDeactivationTime(state.idle_s);
    const int awake = state.drowsy ? WANTS_DEACTIVATION : ACTIVE_TAG;
    body.forceActivationState(body.isStaticObject() || state.asleep ? ISLAND_SLEEPING : awake);
}

BodyState read_state(const btRigidBody& body) {
    const btQuaternion q = body.getOrientation();
    return {.position = from_bullet(body.getCenterOfMassPosition()),
            .orientation = {q.w(), q.x(), q.y(), q.z()},
            .velocity = from_bullet(body.getLinearVelocity()),
            .spin = from_bullet(body.getAngularVelocity()),
            .idle_s = body.getDeactivationTime(),
            .drowsy = body.getActivationState() == WANTS_DEACTIVATION,
            .asleep = body.getActivationState() == ISLAND_SLEEPING};
}

BulletBody make_body(Key key, const BodyDesc& desc, const BodyState& state, const std::vector<Mesh>& meshes,
                     const Settings& settings) {
    BulletBody made;
    made.own_shape = make_shape(desc);
    btCollisionShape* shape = made.own_shape ? made.own_shape.get() : meshes[desc.mesh].shape();
    btVector3 inertia(0, 0, 0);
    if (desc.mass > 0 && !desc.upright) shape->calculateLocalInertia(desc.mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(desc.mass, nullptr, shape, inertia);
    info.m_startWorldTransform = transform_of(state);
    info.m_friction = desc.friction;
    info.m_restitution = desc.restitution;
    info.m_rollingFriction = desc.rolling_friction;
    info.m_linearSleepingThreshold = settings.sleep_speed;
    info.m_angularSleepingThreshold = settings.sleep_spin;
    made.body = std::make_unique<btRigidBody>(info);
    made.body->setUserIndex(static_cast<int>(key));
    if (desc.upright) made.body->setAngularFactor(0);
    if (desc.shape == Shape::mesh) {
        made.body->setCollisionFlags(made.body->getCollisionFlags() |
                                     btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    }
    write_motion(*made.body, state);
    return made;
}

Algorithms::Algorithms(const btDefaultCollisionConstructionInfo& info)
    : btDefaultCollisionConfiguration(info), several_points_(m_pdSolver), capsule_box_(m_pdSolver) {
    several_points_.m_numPerturbationIterations = 3;
    several_points_.m_minimumPointsPerturbationThreshold = 3;
}

btCollisionAlgorithmCreateFunc* Algorithms::getCollisionAlgorithmCreateFunc(int type_a, int type_b) {
    const bool cylinder = type_a == CYLINDER_SHAPE_PROXYTYPE || type_b == CYLINDER_SHAPE_PROXYTYPE;
    const bool both_convex = btBroadphaseProxy::isConvex(type_a) && btBroadphaseProxy::isConvex(type_b);
    if (cylinder && both_convex) return &several_points_;
    const auto is_pair = [&](int a, int b) { return type_a == a && type_b == b; };
    if (is_pair(CAPSULE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE) ||
        is_pair(BOX_SHAPE_PROXYTYPE, CAPSULE_SHAPE_PROXYTYPE))
        return &capsule_box_;
    return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(type_a, type_b);
}

BulletWorld::BulletWorld(const Settings& settings)
    : configuration_(pools_for(settings)),
      dispatcher_(&configuration_),
      broadphase_(to_bullet(vec3(-settings.world_half_extent)), to_bullet(vec3(settings.world_half_extent)),
                  settings.max_bodies + 1, nullptr, true),
      world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.exact_flight = settings.exact_flight;
    world_.setGravity(to_bullet(settings.gravity));
    world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
    world_.getPairCache()->setOverlapFilterCallback(&no_static_pairs());
    btContactSolverInfo& solver = world_.getSolverInfo();
    solver.m_numIterations = settings.solver_iterations;
    solver.m_splitImpulse = 1;
    solver.m_splitImpulsePenetrationThreshold = 0;
    solver.m_warmstartingFactor = 1;
    solver.m_leastSquaresResidualThreshold = settled_speed * settled_speed;
    solver.m_minimumSolverBatchSize = 1;
}

BulletWorld::~BulletWorld() = default;

}  // namespace thaum::physics::detail
