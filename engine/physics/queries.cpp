// Rays, swept spheres, and surfaces near a point. They use the states of the bodies. Of Bullet's data they
// use only the search tree of bounding boxes, whose structure changes no result.
#include <algorithm>

#include "core/assert.h"
#include "physics/detail/physics_impl.h"

namespace thaum::physics {

using detail::Body;

std::optional<detail::CastHit> Physics::Impl::cast_at(const Body& body, const detail::Path& path) const {
    const quat to_local = glm::conjugate(body.state.orientation);
    detail::Path local = path;
    local.from = to_local * (path.from - body.state.position);
    local.direction = to_local * path.direction;
    auto contact = body.desc.shape == Shape::mesh
                       ? meshes[body.desc.mesh].cast(local)
                       : detail::cast(local, [&](vec3 p) { return detail::nearest_to(body.desc, p); });
    if (contact) contact->normal = body.state.orientation * contact->normal;
    return contact;
}

template <class Each>
void Physics::Impl::each_near(const detail::Box& box, const Each& each) const {
    detail::NearKeys keys;
    const auto near = tree.near(box, keys);
    if (!near) {
        for (const Body& body : bodies) each(body);
        return;
    }
    auto from = bodies.begin();
    for (const Key key : *near) {
        from = key < places.size() ? bodies.begin() + places[key]
                                   : std::ranges::lower_bound(from, bodies.end(), key, {}, &Body::key);
        each(*from);
    }
}

template <class Each>
void Physics::Impl::each_along(const detail::Path path, const Each& each) const {
    // Path length above which the bounding box has so many bodies that the tree saves no time (m).
    constexpr double long_path = 4;
    if (path.length > long_path) {
        for (const Body& body : bodies) each(body);
        return;
    }
    const vec3 to = path.from + path.length * path.direction;
    const double size = path.radius + 2 * detail::touching;
    each_near({glm::min(path.from, to) - size, glm::max(path.from, to) + size}, each);
}

std::optional<RayHit> Physics::ray(vec3 from, vec3 to, Layers mask, Key ignore_key) const {
    return sweep_sphere(from, to, 0, mask, ignore_key);
}

std::optional<RayHit> Physics::sweep_sphere(vec3 from, vec3 to, double radius, Layers mask,
                                            Key ignore_key) const {
    THAUM_ASSERT(is_finite(from) && is_finite(to) && radius >= 0,
                 "ray or sweep: an end is not finite or the radius is negative");
    const double length = glm::length(to - from);
    if (length == 0) return std::nullopt;
    const Impl& in = *impl_;
    detail::Path path{from, (to - from) / length, length, radius};
    const Body* nearest = nullptr;
    detail::CastHit contact{};
    in.each_along(path, [&](const Body& body) {
        if ((body.desc.layer & mask) == 0 || body.key == ignore_key) return;
        if (!may_touch(body, path)) return;
        const auto here = in.cast_at(body, path);
        if (!here || (nearest && here->travelled >= contact.travelled)) return;
        nearest = &body;
        contact = *here;
        path.length = contact.travelled;  // shortens the path, so that only nearer hits count from here on
    });
    if (!nearest) return std::nullopt;
    const vec3 centre = from + contact.travelled * path.direction;
    return RayHit{nearest->key, centre - radius * contact.normal, contact.normal, contact.travelled / length};
}

void Physics::Impl::gather_from(const Body& body, vec3 point, detail::NearestSurfaces& into) const {
    const BodyState& s = body.state;
    const vec3 local = glm::conjugate(s.orientation) * (point - s.position);
    Nearby surface{.key = body.key, .shape = body.desc.shape, .velocity = velocity_at(s, point)};
    if (body.desc.shape != Shape::mesh) {
        surface.distance = std::max(0.0, detail::nearest_to(body.desc, local).distance);
        surface.a = s.position;
        surface.b = body.desc.size;
        if (detail::wanted(into, surface.distance)) detail::add(into, surface);
        return;
    }
    meshes[body.desc.mesh].gather(local, surface, into);
    const mat3 turn = glm::mat3_cast(s.orientation);
    for (std::size_t i = 0; i < into.found.count; ++i) {
        Nearby& t = into.into[i];
        if (t.key != body.key) continue;
        for (vec3* corner : {&t.a, &t.b, &t.c}) *corner = s.position + turn * *corner;
    }
}

NearbyResult Physics::nearby(vec3 point, double radius, std::span<Nearby> into, Layers mask,
                             Key ignore_key) const {
    THAUM_ASSERT(is_finite(point) && radius >= 0,
                 "nearby: the point is not finite or the radius is negative");
    const Impl& in = *impl_;
    detail::NearestSurfaces gathering{into, {0, radius}};
    const double size = radius + detail::touching;
    in.each_near({point - size, point + size}, [&](const Body& body) {
        if ((body.desc.layer & mask) == 0 || body.key == ignore_key) return;
        const vec3 apart = body.state.position - point;
        const double meeting = body.reach + radius;
        if (glm::dot(apart, apart) <= meeting * meeting) in.gather_from(body, point, gathering);
    });
    return gathering.found;
}

}  // namespace thaum::physics
