#include "physics/detail/capsule_box.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <new>
#include <span>

namespace thaum::physics::detail {
namespace {

/// Distance from the box below which a capsule's axis counts as inside it, since the direction of the contact
/// is then uncertain (m).
constexpr double inside = 1e-6;
/// Components of the half axis below this count as zero, so that an axis along a face touches it with its
/// middle and not, by rounding, with an end (m).
constexpr double parallel = 1e-9;

/// Half the derivative, along the segment, of the squared distance from the box, at `centre` + t * `half`.
double slope(vec3 centre, vec3 half, vec3 box_half, double t) {
    const vec3 point = centre + t * half;
    return glm::dot(half, point - glm::clamp(point, -box_half, box_half));
}

/// Place of zero slope between two places whose slopes have different signs.
double crossing(double from, double from_slope, double to, double to_slope) {
    return from + (to - from) * (from_slope / (from_slope - to_slope));
}

/// The ends of the segment and the places between at which it passes a plane of a face, sorted.
std::span<const double> pieces(vec3 centre, vec3 half, vec3 box_half, std::array<double, 8>& into) {
    std::size_t count = 0;
    into[count++] = -1;
    for (int i = 0; i < 3; ++i) {
        if (half[i] == 0) continue;
        for (const double face : {-box_half[i], box_half[i]}) {
            const double t = (face - centre[i]) / half[i];
            if (t > -1 && t < 1) into[count++] = t;
        }
    }
    into[count++] = 1;
    std::sort(into.begin(), into.begin() + static_cast<std::ptrdiff_t>(count));
    return std::span(into).first(count);
}

/// Place of the nearest point, from -1 to 1 along the segment. The slope never falls along the segment.
double nearest_place(vec3 centre, vec3 half, vec3 box_half) {
    std::array<double, 8> room;
    double place = -1, lowest = 1, highest = -1, before = 0;
    for (const double t : pieces(centre, half, box_half, room)) {
        double here = slope(centre, half, box_half, t);
        // A point on the plane of a face may lie beyond it by rounding.
        if (std::abs(here) < parallel * glm::length(half)) here = 0;
        if (t > place && before < 0 && here > 0) return crossing(place, before, t, here);
        if (here >= 0) lowest = std::min(lowest, t);
        if (here <= 0) highest = t;
        place = t;
        before = here;
    }
    return 0.5 * (lowest + highest);
}

vec3 vector_of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

bool upright(const btCollisionObjectWrapper& object) {
    const btRigidBody* const body = btRigidBody::upcast(object.getCollisionObject());
    return body != nullptr && body->getAngularFactor().isZero();
}

/// Adds the contact, if the shapes are near enough. Returns false if the capsule's axis is inside the box.
bool add_contact(const btCollisionObjectWrapper& capsule, const btCollisionObjectWrapper& box, bool swapped,
                 btManifoldResult& result) {
    const auto& round = *static_cast<const btCapsuleShape*>(capsule.getCollisionShape());
    const auto& flat = *static_cast<const btBoxShape*>(box.getCollisionShape());
    const btTransform& from_box = box.getWorldTransform();
    const btTransform& from_capsule = capsule.getWorldTransform();
    const btVector3 centre = from_box.invXform(from_capsule.getOrigin());
    const btVector3 axis = from_capsule.getBasis().getColumn(round.getUpAxis()) * from_box.getBasis();
    const auto [on_axis, on_box] = nearest_points(vector_of(centre), vector_of(axis * round.getHalfHeight()),
                                                  vector_of(flat.getHalfExtentsWithoutMargin()));
    const vec3 apart = on_axis - on_box;
    const double length = glm::length(apart);
    if (length < inside) return false;
    const double gap = length - round.getRadius() - flat.getMargin();
    if (gap > result.getPersistentManifold()->getContactBreakingThreshold()) return true;
    const vec3 normal = apart / length;
    const btVector3 outward = from_box.getBasis() * btVector3(normal.x, normal.y, normal.z);
    const btVector3 surface = from_box * btVector3(on_box.x, on_box.y, on_box.z) + outward * flat.getMargin();
    if (swapped)
        result.addContactPoint(-outward, surface + outward * gap, gap);
    else
        result.addContactPoint(outward, surface, gap);
    return true;
}

}  // namespace

SegmentToBox nearest_points(vec3 centre, vec3 half_axis, vec3 box_half) {
    for (int i = 0; i < 3; ++i) {
        if (std::abs(half_axis[i]) < parallel) half_axis[i] = 0;
    }
    const vec3 point = centre + nearest_place(centre, half_axis, box_half) * half_axis;
    return {point, glm::clamp(point, -box_half, box_half)};
}

CapsuleBoxAlgorithm::CapsuleBoxAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                         const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                         const btConvexConvexAlgorithm::CreateFunc& settings)
    : btConvexConvexAlgorithm(info.m_manifold ? info.m_manifold
                                              : info.m_dispatcher1->getNewManifold(a->getCollisionObject(),
                                                                                   b->getCollisionObject()),
                              info, a, b, settings.m_pdSolver, settings.m_numPerturbationIterations,
                              settings.m_minimumPointsPerturbationThreshold),
      own_contacts_(info.m_manifold ? nullptr : const_cast<btPersistentManifold*>(getManifold())) {}

CapsuleBoxAlgorithm::~CapsuleBoxAlgorithm() {
    if (own_contacts_) m_dispatcher->releaseManifold(own_contacts_);
}

void CapsuleBoxAlgorithm::processCollision(const btCollisionObjectWrapper* a,
                                           const btCollisionObjectWrapper* b, const btDispatcherInfo& info,
                                           btManifoldResult* result) {
    const bool swapped = a->getCollisionShape()->getShapeType() == BOX_SHAPE_PROXYTYPE;
    const btCollisionObjectWrapper &capsule = swapped ? *b : *a, &box = swapped ? *a : *b;
    result->setPersistentManifold(const_cast<btPersistentManifold*>(getManifold()));
    if (!upright(capsule) || !add_contact(capsule, box, swapped, *result))
        btConvexConvexAlgorithm::processCollision(a, b, info, result);
    if (own_contacts_) result->refreshContactPoints();
}

void CapsuleBoxAlgorithm::getAllContactManifolds(btManifoldArray& all) {
    if (own_contacts_) all.push_back(own_contacts_);
}

btCollisionAlgorithm* CapsuleBoxAlgorithm::CreateFunc::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
    const btCollisionObjectWrapper* b) {
    void* const memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(CapsuleBoxAlgorithm));
    return new (memory) CapsuleBoxAlgorithm(info, a, b, *this);
}

}  // namespace thaum::physics::detail
