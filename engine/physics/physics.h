// physics/physics.h: rigid bodies. Bullet computes; this face makes it repeatable to the bit.
//
// A body is known by a key of the caller's choice (the game takes the entity's index). What it is stands in a BodyDesc,
// all that decides its future in a BodyState; both are plain values without padding, fit for components and hashes.
//
//     Physics physics({}, {});
//     physics.add(1, {.shape = Shape::box, .size = {50, 1, 50}}, {.position = {0, -1, 0}});        // a floor
//     physics.add(2, {.shape = Shape::sphere, .size = {0.1, 0, 0}, .mass = 1}, {.position = {0, 2, 0}});
//     for (;;) physics.step(0.001);
//
// Bullet also remembers what no state can hold (contact caches, orders of lists). rebuild() throws that away and starts
// again from the states alone, bodies in the order of their keys. A run that rebuilds at fixed ticks can therefore be
// restored at any of those: make a Physics, add all bodies in any order, rebuild(), and it goes on to the same bits.
// The price is that resting contacts start cold, once per keyframe.
//
// Wrong use is an assertion that names the key: an unknown or doubled key, a state or impulse that is not finite, more
// bodies or contacts than Settings allows. One Physics serves one thread at a time; several may run side by side.
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

using Key = std::uint32_t;

/// ignore_key of a ray that ignores nobody; not a key itself.
inline constexpr Key no_key = 0xffffffff;

/// Bit set of layers.
using Layers = std::uint32_t;
inline constexpr Layers all_layers = 0xffffffff;

/// Capsule and cylinder stand along the body's y axis.
enum class Shape : std::uint32_t { box, sphere, capsule, cylinder, mesh };

/// What a body is.
struct BodyDesc {
    Shape shape{};
    std::uint32_t mesh{};  ///< index in Physics' list of meshes; used by Shape::mesh
    /// m. box: half extents; sphere: radius in x; capsule, cylinder: radius in x, half the length of the cylindrical
    /// part in y; mesh: unused.
    vec3 size{0.5, 0.5, 0.5};
    double mass{};  ///< kg; 0: static, as a mesh must be. A stack carries 200 times its lightest body.
    /// The product of a pair counts. Restitution: rebound by approach speed, where that is 0.2 m/s and more (cylinders: 5 %).
    double friction{0.7};
    double restitution{};
    double rolling_friction{};  ///< m: torque per newton of normal force; stops a ball
    double linear_damping{};    ///< share of the velocity lost per second, [0, 1)
    double angular_damping{};
    Layers layer{1};                   ///< bits of the layers it is in
    Layers collides_with{all_layers};  ///< two bodies collide when each is in a layer of the other's set
    std::uint32_t upright{};           ///< 1: never rotates (a wizard's capsule)
    std::uint32_t swept{};  ///< 1: its centre never passes a static body in a step, however thin or fast
    bool operator==(const BodyDesc&) const = default;
};
static_assert(std::is_trivially_copyable_v<BodyDesc> && std::has_unique_object_representations_v<Shape>);
static_assert(sizeof(BodyDesc) == 6 * sizeof(std::uint32_t) + 3 * sizeof(double) + 6 * sizeof(double));

/// All that decides a body's future; world frame.
struct BodyState {
    vec3 position{};               ///< m, centre of mass
    quat orientation{1, 0, 0, 0};  ///< unit
    vec3 velocity{};               ///< m/s
    vec3 spin{};                   ///< rad/s
    double idle_s{};               ///< s it has been slow for; sleep comes after 2
    std::uint32_t drowsy{};        ///< 1: slow for long enough, but touched by something that is not
    std::uint32_t asleep{};        ///< 1: stands still, without cost, until touched
};
static_assert(std::is_trivially_copyable_v<BodyState>);
static_assert(sizeof(BodyState) == 14 * sizeof(double) + 2 * sizeof(std::uint32_t));

/// m/s, of the body where the point is, m, world.
inline vec3 velocity_at(const BodyState& s, vec3 point) {
    return s.velocity + glm::cross(s.spin, point - s.position);
}

/// Static geometry. Triangles are one-sided: counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<vec3> vertices;  ///< m, body frame
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool operator==(const TriangleMesh&) const = default;
};

/// Two bodies that pressed on each other in the last step.
struct Contact {
    Key a{}, b{};    ///< a < b
    vec3 point;      ///< m, world; mean of the contact points, weighted by impulse
    vec3 normal;     ///< unit, from b towards a
    double impulse;  ///< N s, normal, sum over the pair's points; > 0
    bool began;      ///< they did not touch before
};

struct RayHit {
    Key key{};
    vec3 point;       ///< m, on the body's surface; the start, if that lies inside
    vec3 normal;      ///< unit, outward; against the ray, if it starts inside
    double fraction;  ///< of the way from start to end, [0, 1]; of a sphere: where its centre is then
};

/// One surface near a point, world frame: a whole solid where it is, or one triangle of a mesh.
struct Nearby {
    Key key{};
    Shape shape{};         ///< mesh: one triangle of it
    std::uint32_t part{};  ///< index of the triangle in its mesh; 0
    double distance{};     ///< m, from the point; 0 inside a solid
    vec3 a{}, b{},
        c{};  ///< m. mesh: the corners, counter-clockwise from outside; else a: centre, b: BodyDesc::size
    vec3 velocity{};  ///< m/s, of the body where the point is
};

struct NearbyResult {
    std::size_t count{};  ///< in the caller's array
    double
        reach{};  ///< m: all surfaces nearer than this are among them; less than the radius asked for, if it was full
};

struct Settings {
    vec3 gravity{0, -9.81, 0};         ///< m/s^2
    std::uint32_t max_bodies{1024};    ///< <= 30,000
    std::uint32_t max_contacts{4096};  ///< touching pairs
    double world_half_extent{1000};    ///< m; beyond it pairs are still found, but slower
    double max_speed{200};             ///< m/s; a faster body is slowed to it
    double max_spin{100};              ///< rad/s
    int solver_iterations{10};
    double sleep_speed{0.15};  ///< m/s; slower than both for 2 s is asleep
    double sleep_spin{0.3};    ///< rad/s
    bool skip_asleep{true};    ///< a step in which nothing can change returns at once; off only to prove that
    bool exact_flight{true};   ///< see step(); off only to measure what it is worth
};

struct Counters {
    std::uint64_t steps{};    ///< asked for
    std::uint64_t skipped{};  ///< of these, the ones that had nothing to do
    std::uint32_t bodies{};
    std::uint32_t awake{};  ///< dynamic bodies not asleep after the last step
};

class Physics {
public:
    /// Throws std::bad_alloc at most; wrong settings or an empty mesh are assertions.
    explicit Physics(const Settings& settings = {}, const std::vector<TriangleMesh>& meshes = {});
    ~Physics();
    Physics(Physics&&) noexcept;
    Physics& operator=(Physics&&) noexcept;

    /// Wakes nobody, or a restored run would differ; a dynamic body that is awake wakes what it meets. After putting a static
    /// one among sleepers call wake_touching().
    void add(Key, const BodyDesc&, const BodyState&);
    /// Wakes what may have rested on it.
    void remove(Key);
    bool has(Key) const;

    const BodyDesc& desc(Key) const;
    const BodyState& state(Key) const;
    /// Teleports. Wakes what may have touched it, before and after.
    void set_state(Key, const BodyState&);
    vec3 velocity(Key key) const { return state(key).velocity; }
    /// m/s; wakes.
    void set_velocity(Key, vec3);
    /// rad/s; wakes.
    void set_spin(Key, vec3);

    /// impulse in N s at a point in the world, m. Wakes; a static body ignores it.
    void apply_impulse(Key, vec3 impulse, vec3 point);
    void apply_central_impulse(Key, vec3 impulse);
    /// A central impulse that leaves the body free to fall asleep, and does nothing to one that is.
    void nudge(Key, vec3 impulse);
    void wake(Key);
    /// The sleepers that may touch this body.
    void wake_touching(Key);

    /// One step of dt seconds, > 0. Returns at once where all sleep and nothing was touched since. A body on which nothing
    /// but gravity and damping acted is where the law of motion puts it, whatever dt; the others move by semi-implicit Euler.
    void step(double dt);

    /// Of the last step, sorted by (a, b); empty after a skipped step or a rebuild. Valid until the next call that is not const.
    std::span<const Contact> contacts() const;

    /// The nearest body on the way whose layer is in mask; of two at the same distance the lower key. Exact (1 nm) for every
    /// shape and length of ray; allocates nothing.
    std::optional<RayHit> ray(vec3 from, vec3 to, Layers mask = all_layers, Key ignore_key = no_key) const;
    /// The same for a sphere's centre; as exact, no thing too thin for it.
    std::optional<RayHit> sweep_sphere(vec3 from, vec3 to, double radius, Layers mask = all_layers,
                                       Key ignore_key = no_key) const;
    /// What lies within `radius` of the point, m, as exact as a ray; the nearest where the array does not hold all. In the order
    /// of keys, triangles in one that their mesh alone decides. Allocates nothing; for a patch that a hand can touch.
    NearbyResult nearby(vec3 point, double radius, std::span<Nearby> into, Layers mask = all_layers,
                        Key ignore_key = no_key) const;

    /// Forgets all that is not in a BodyState (see above). Contacts become empty.
    void rebuild();

    Counters counters() const;
    const Settings& settings() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace thaum::physics
