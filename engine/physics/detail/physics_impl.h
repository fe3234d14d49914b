// physics/detail/physics_impl.h: the data behind Physics: the bodies,
// Bullet's world, and the pairs in contact.
#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "physics/detail/bound_tree.h"
#include "physics/detail/bullet_world.h"
#include "physics/detail/cast.h"
#include "physics/physics.h"

namespace thaum::physics {
namespace detail {

/// A body: its constant properties, its state, and the tables and objects made from them.
struct Body {
    Key key{};
    bool was_asleep{};  ///< true: asleep before the step
    BodyDesc desc;
    BodyState state;
    double reach{};  ///< distance of the body's farthest point from its position (m)
    /// Share of its velocity that damping leaves the body after a step of damping_dt.
    double kept_velocity{};
    double kept_spin{};
    /// Velocity that gravity gives in a step of damping_dt, divided by gravity. It is also the path of a body
    /// in that step without gravity, divided by its initial velocity (s).
    double drive_s{};
    double fall_s2{};       ///< path that gravity gives in a step of damping_dt, divided by gravity (s^2)
    vec3 start_velocity{};  ///< velocity at the start of the step (m/s)
    BulletBody bullet;
    BoundTree::Leaf leaf{};

    btRigidBody& bt() const { return *bullet.body; }
    bool dynamic() const { return desc.mass > 0; }
};

/// Keys of two bodies that touch; the smaller key first.
struct Pair {
    Key a, b;
    auto operator<=>(const Pair&) const = default;
};

/// Whether a path may touch the body, tested with the body's bounding sphere.
inline bool may_touch(const Body& body, const Path& path) {
    const vec3 offset = body.state.position - path.from;
    const double along = std::clamp(glm::dot(offset, path.direction), 0.0, path.length);
    const vec3 apart = offset - along * path.direction;
    const double meeting = body.reach + path.radius + touching;
    return glm::dot(apart, apart) <= meeting * meeting;
}

}  // namespace detail

/// All data of a Physics. Steps are in physics.cpp, queries in queries.cpp.
struct Physics::Impl {
    Settings settings;
    std::vector<detail::Mesh> meshes;
    std::vector<detail::Body> bodies;  ///< bodies, sorted by key
    /// Indices in `bodies` of the bodies with keys below max_bodies, by key; bodies with other keys are
    /// searched.
    std::vector<std::uint16_t> places;
    detail::BoundTree tree;  ///< bounding boxes of the bodies at their current positions
    std::unique_ptr<detail::BulletWorld> world;
    std::vector<Contact> contacts;
    std::vector<detail::Pair> touching;  ///< pairs that pressed on each other and are still close; sorted
    std::vector<detail::Pair> touching_next;
    Counters counters;
    double damping_dt{};
    bool skipped{};    ///< true: the last step returned at once
    bool unchanged{};  ///< true: the last step changed nothing, and nothing was touched since

    Impl(const Settings& s, const std::vector<TriangleMesh>& m);
    ~Impl() { world.reset(); }  // the world must be destroyed before the bodies in it

    static constexpr std::uint16_t no_place = 0xffff;

    void update_places();
    detail::Body* find(Key);
    detail::Body& at(Key);
    void enter_world(detail::Body&);
    void wake(detail::Body&);
    void wake_near(const detail::Box&);
    void prepare_damping(detail::Body&) const;
    void before_step(double dt);
    void correct_flight(detail::Body&, vec3 from) const;
    void stop_at_walls(detail::Body&, const BodyState& from) const;
    double free_share(const detail::Body&, vec3 start, vec3 end, double radius) const;
    bool after_step();
    void collect_contacts();
    void find_touching();
    std::optional<detail::CastHit> cast_at(const detail::Body&, const detail::Path&) const;
    /// Adds the body's surfaces within the radius of the point.
    void gather_from(const detail::Body&, vec3 point, detail::NearestSurfaces&) const;
    /// Calls `each` for each body whose bounding box meets the box, and possibly for others, in the order of
    /// keys.
    template <class Each>
    void each_near(const detail::Box&, const Each& each) const;
    /// Calls `each` for each body whose bounding box meets that of the path, and possibly for others, in the
    /// order of keys.
    template <class Each>
    void each_along(detail::Path, const Each& each) const;
};

}  // namespace thaum::physics
