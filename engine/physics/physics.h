// physics/physics.h: rigid bodies that repeat to the bit. Bullet computes the motion; this interface makes it
// repeatable.
//
// A body is identified by a key that the caller chooses (the game uses the entity's index). Its
// constant properties are a BodyDesc. Everything that decides its future is a BodyState. Both are plain
// values without padding, suitable for components and hashes.
//
//     Physics physics({}, {});
//     physics.add(1, {.shape = Shape::box, .size = {50, 1, 50}}, {.position = {0, -1, 0}});        // a floor
//     physics.add(2, {.shape = Shape::sphere, .size = {0.1, 0, 0}, .mass = 1}, {.position = {0, 2, 0}});
//     for (;;) physics.step(0.001);
//
// Bullet also keeps data that no state contains, such as contact caches and orders of lists. rebuild()
// discards these data and starts again from the states alone, bodies in the order of their keys. A run
// that rebuilds at fixed ticks can be restored at any of these ticks: make a Physics, add all bodies in
// any order, and call rebuild(). It then continues with the same bits. The cost is that resting
// contacts start without cached impulses after each rebuild.
//
// Wrong use fails an assertion that names the key. Examples are an unknown or duplicate key, a state or
// impulse that is not finite, or more bodies or contacts than Settings allows. One Physics may be used by one
// thread at a time; several may run in parallel.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/maths.h"

namespace thaum::physics {

/// Identifies a body; chosen by the caller.
using Key = std::uint32_t;

/// Value of ignore_key if a ray ignores no body; never the key of a body.
inline constexpr Key no_key = 0xffffffff;

/// Set of layers, one bit each. Layers are groups of bodies; they decide which bodies collide.
using Layers = std::uint32_t;
inline constexpr Layers all_layers = 0xffffffff;

/// Shape of a body. The axis of a capsule or cylinder is the body's y axis.
enum class Shape : std::uint32_t { box, sphere, capsule, cylinder, mesh };

/// Constant properties of a body.
struct BodyDesc {
    Shape shape{};
    std::uint32_t mesh{};  ///< index in the list of meshes given to Physics; used only by Shape::mesh
    /// Size (m). Box: half extents. Sphere: radius in x. Capsule and cylinder: radius in x, half the
    /// length of the cylindrical part in y. Mesh: unused.
    vec3 size{0.5, 0.5, 0.5};
    /// Mass (kg); 0: static, required for a mesh. A stack can carry 200 times the mass of its lightest body.
    double mass{};
    /// Friction and restitution. For two bodies in contact, the product of both values counts. Restitution is
    /// the ratio of the speed after a bounce to the speed before, for bounces from 0.2 m/s on (cylinders:
    /// within 5 %).
    double friction{0.7};
    double restitution{};
    double rolling_friction{};  ///< friction torque per newton of normal force; stops a rolling ball (m)
    double linear_damping{};    ///< share of the velocity lost per second, [0, 1)
    double angular_damping{};
    Layers layer{1};  ///< layers that the body belongs to
    /// Layers that the body collides with. Two bodies collide if each belongs to a layer of the other's set.
    Layers collides_with{all_layers};
    std::uint32_t upright{};  ///< 1: the body never rotates (as the capsule of a wizard)
    /// 1: the body's centre never passes through a static body in a step, however thin the static body or
    /// fast this body.
    std::uint32_t swept{};
    bool operator==(const BodyDesc&) const = default;
};
static_assert(std::is_trivially_copyable_v<BodyDesc> && std::has_unique_object_representations_v<Shape>);
static_assert(sizeof(BodyDesc) == 6 * sizeof(std::uint32_t) + 3 * sizeof(double) + 6 * sizeof(double));

/// Everything that decides a body's future; world frame.
struct BodyState {
    vec3 position{};               ///< centre of mass (m)
    quat orientation{1, 0, 0, 0};  ///< orientation, a unit quaternion
    vec3 velocity{};               ///< velocity (m/s)
    vec3 spin{};                   ///< angular velocity (rad/s)
    double idle_s{};               ///< time for which the body has been slow (s); it may sleep after 2 s
    /// 1: the body was slow for long enough to sleep, but is kept awake by another body that touches it
    std::uint32_t drowsy{};
    std::uint32_t asleep{};  ///< 1: the body is at rest and costs no computation until touched
};
static_assert(std::is_trivially_copyable_v<BodyState>);
static_assert(sizeof(BodyState) == 14 * sizeof(double) + 2 * sizeof(std::uint32_t));

/// Velocity of the body (m/s, world) at a point (m, world).
inline vec3 velocity_at(const BodyState& s, vec3 point) {
    return s.velocity + glm::cross(s.spin, point - s.position);
}

/// Geometry of static bodies. Triangles are one-sided: counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<vec3> vertices;  ///< vertices (m, body frame)
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool operator==(const TriangleMesh&) const = default;
};

/// Two bodies that pressed on each other in the last step.
struct Contact {
    Key a{}, b{};    ///< keys, a < b
    vec3 point;      ///< mean of the contact points, weighted by impulse (m, world)
    vec3 normal;     ///< normal of the contact, from b towards a (unit, world)
    double impulse;  ///< sum of the normal impulses, > 0 (N s)
    bool began;      ///< true: the bodies did not touch before
};

/// First hit of a ray or swept sphere, world frame.
struct RayHit {
    Key key{};
    vec3 point;       ///< point on the body's surface; the start of the ray if it is inside (m, world)
    vec3 normal;      ///< normal at the hit, outward (unit); opposite to the ray if it starts inside
    double fraction;  ///< share of the path from start to end, [0, 1]; for a sphere, of its centre's path
};

/// One surface near a point, world frame: a whole solid, or one triangle of a mesh.
struct Nearby {
    Key key{};
    Shape shape{};         ///< shape of the body; Shape::mesh: the surface is one triangle of it
    std::uint32_t part{};  ///< index of the triangle in its mesh, else 0
    double distance{};     ///< distance from the point; 0 inside a solid (m)
    /// Mesh: corners of the triangle, counter-clockwise from outside (m). Else a is the centre (m) and b is
    /// BodyDesc::size.
    vec3 a{}, b{}, c{};
    vec3 velocity{};  ///< velocity of the body at the point (m/s)
};

/// Result of Physics::nearby(): how many surfaces it found near a point, and up to which distance it found
/// all.
struct NearbyResult {
    std::size_t count{};  ///< number of surfaces written to the caller's array
    /// All surfaces nearer than this were found (m). It is less than the requested radius if the array was
    /// full.
    double reach{};
};

/// Settings of a world of bodies; the defaults work.
struct Settings {
    vec3 gravity{0, -9.81, 0};         ///< gravity (m/s^2)
    std::uint32_t max_bodies{1024};    ///< largest number of bodies, <= 30,000
    std::uint32_t max_contacts{4096};  ///< largest number of touching pairs
    /// Half the edge of the region in which the search for pairs is fast; beyond it the search is slower (m).
    double world_half_extent{1000};
    double max_speed{200};  ///< largest speed; faster bodies are slowed to it (m/s)
    double max_spin{100};   ///< largest angular speed (rad/s)
    int solver_iterations{10};
    double sleep_speed{0.15};  ///< speed below which a body may fall asleep after 2 s (m/s)
    double sleep_spin{0.3};    ///< angular speed below which a body may fall asleep after 2 s (rad/s)
    bool skip_asleep{true};    ///< true: skip steps in which nothing can change; false only to test this
    /// true: a body in free flight ends each step at its exact place, see step(); false only to measure the
    /// effect.
    bool exact_flight{true};
};

/// Statistics of a world of bodies.
struct Counters {
    std::uint64_t steps{};    ///< steps requested
    std::uint64_t skipped{};  ///< steps that were skipped because nothing could change
    std::uint32_t bodies{};
    std::uint32_t awake{};  ///< dynamic bodies that were awake after the last step
};

/// A world of rigid bodies.
class Physics {
public:
    /// Makes a world without bodies. May throw std::bad_alloc. Wrong settings or an empty mesh fail an
    /// assertion.
    explicit Physics(const Settings& settings = {}, const std::vector<TriangleMesh>& meshes = {});
    ~Physics();
    Physics(Physics&&) noexcept;
    Physics& operator=(Physics&&) noexcept;

    /// Adds a body. Adding it wakes no other body, because otherwise a restored run would differ. In the next
    /// steps an awake dynamic body wakes the bodies it meets; a static body added among sleeping ones wakes
    /// none.
    void add(Key, const BodyDesc&, const BodyState&);
    /// Removes a body. Wakes bodies that may have rested on it.
    void remove(Key);
    /// Whether a body with this key exists.
    bool has(Key) const;

    /// Description with which the body was added.
    const BodyDesc& desc(Key) const;
    /// Place and motion of the body.
    const BodyState& state(Key) const;
    /// Sets the state of a body, which moves it at once. Wakes bodies that may have touched it before or
    /// touch it afterwards.
    void set_state(Key, const BodyState&);
    /// Velocity of the body's centre of mass (m/s).
    vec3 velocity(Key key) const { return state(key).velocity; }
    /// Sets the velocity (m/s) and wakes the body.
    void set_velocity(Key, vec3);
    /// Sets the angular velocity (rad/s) and wakes the body.
    void set_spin(Key, vec3);

    /// Applies an impulse (N s) at a point (m, world) and wakes the body; a static body ignores it.
    void apply_impulse(Key, vec3 impulse, vec3 point);
    /// Applies an impulse (N s) at the centre of mass and wakes the body; a static body ignores it.
    void apply_central_impulse(Key, vec3 impulse);
    /// Applies an impulse (N s) at the centre of mass. The time for which the body has been slow goes on, so
    /// it can still fall asleep; a sleeping body ignores the impulse.
    void nudge(Key, vec3 impulse);
    /// Wakes the body and resets its idle time; a static body ignores it.
    void wake(Key);

    /// Advances by dt (s), > 0. Returns at once if all bodies sleep and nothing was touched since the
    /// last step. A body under gravity and damping alone follows the exact law of motion for any dt;
    /// other bodies move by semi-implicit Euler.
    void step(double dt);
    /// Whether the last step returned at once because nothing could change.
    bool skipped_last_step() const;

    /// Contacts of the last step, sorted by (a, b); empty after a skipped step or a rebuild. Valid
    /// until the next call that is not const.
    std::span<const Contact> contacts() const;

    /// First body along the path whose layer is in `mask`; of two at the same distance, the one with the
    /// lower key. Exact to 1 nm for every shape and length. Does not allocate.
    std::optional<RayHit> ray(vec3 from, vec3 to, Layers mask = all_layers, Key ignore_key = no_key) const;
    /// First body that a sphere touches while its centre moves from `from` to `to`; of two at the same
    /// distance, the one with the lower key. As exact as `ray`, so even the thinnest body is found. Does not
    /// allocate.
    std::optional<RayHit> sweep_sphere(vec3 from, vec3 to, double radius, Layers mask = all_layers,
                                       Key ignore_key = no_key) const;
    /// Surfaces within `radius` (m) of a point, as exact as a ray. If the array is too small, it gets the
    /// nearest ones. Sorted by key; the order of triangles depends only on their mesh. Does not allocate.
    /// Used for the patch of surfaces that a hand can touch.
    NearbyResult nearby(vec3 point, double radius, std::span<Nearby> into, Layers mask = all_layers,
                        Key ignore_key = no_key) const;

    /// Discards everything that is not in a BodyState, such as contact caches, and starts again from the
    /// states alone. Contacts become empty.
    void rebuild();

    /// Statistics: steps since the start, and the present numbers of bodies.
    Counters counters() const;
    /// Settings of the simulation.
    const Settings& settings() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace thaum::physics
