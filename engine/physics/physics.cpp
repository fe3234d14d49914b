// Bodies are in one array, sorted by key, each with its description (BodyDesc) and its state. This state is
// authoritative. It is copied to Bullet when a body is made, and read back after each step in which the body
// was awake. Queries and rebuilds use only this state, so a rebuild never rounds a state and acts in the same
// way in a restored run.
//
// Bullet moves a body by the velocity at the end of the step. In free fall this is g dt^2/2 too far in
// every step: 9.8 mm after 2 s at 1 kHz. The exact end of a free flight is known, so a body on which
// nothing pushed is moved there (Settings::exact_flight). Velocity and path show whether it was pushed,
// so this needs no stored data.
#include "physics/physics.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/assert.h"
#include "core/text.h"
#include "physics/bullet_maths.h"
#include "physics/detail/checks.h"
#include "physics/detail/physics_impl.h"
#include "physics/detail/pool.h"
#include "physics/detail/swept.h"

namespace thaum::physics {
namespace {

using detail::about;
using detail::Body;
using detail::Box;
using detail::from_bullet;
using detail::Pair;
using detail::to_bullet;

/// A body this close to a removed or moved one may have rested on it (m).
constexpr double resting_gap = 0.02;
/// Largest difference from a free flight that counts as rounding and not as a push: of velocities (m/s,
/// relative above 1 m/s) and positions (m).
constexpr double push_tolerance = 1e-9;
/// Distance within which bodies count as having touched before a rebuild, which discards the pairs in contact
/// (m).
constexpr double touching_gap = 0.002;

Box box_around(const Body& body) {
    btVector3 low, high;
    body.bt().getCollisionShape()->getAabb(body.bt().getWorldTransform(), low, high);
    return {from_bullet(low), from_bullet(high)};
}

bool overlap(const Box& a, const Box& b, double gap) {
    for (int i = 0; i < 3; ++i) {
        if (a.low[i] > b.high[i] + gap || b.low[i] > a.high[i] + gap) return false;
    }
    return true;
}

bool collide(const BodyDesc& a, const BodyDesc& b) {
    return (a.layer & b.collides_with) != 0 && (b.layer & a.collides_with) != 0;
}

/// The given state, with zero velocities if the body is asleep.
BodyState at_rest_if_asleep(BodyState state) {
    if (state.asleep) state.velocity = state.spin = vec3{};
    return state;
}

Pair pair_of(const btPersistentManifold& manifold) {
    const Key a = detail::key_of(*manifold.getBody0()), b = detail::key_of(*manifold.getBody1());
    return a < b ? Pair{a, b} : Pair{b, a};
}

/// Contact of a pair, summed over its contact points in the last step. The caller sets `began`, whether it is
/// new.
Contact contact_of(const btPersistentManifold& manifold) {
    const Pair pair = pair_of(manifold);
    Contact contact{pair.a, pair.b, {}, {}, 0, false};
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const double impulse = point.m_appliedImpulse;
        contact.impulse += impulse;
        contact.point += impulse * from_bullet(point.getPositionWorldOnB());
        contact.normal += impulse * from_bullet(point.m_normalWorldOnB);
    }
    if (contact.impulse <= 0) return contact;
    contact.point /= contact.impulse;
    const double length = glm::length(contact.normal);  // 0: the contact points press in opposite directions
    contact.normal = length > 0 ? contact.normal / length : vec3{0, 1, 0};
    if (detail::key_of(*manifold.getBody0()) != pair.a) contact.normal = -contact.normal;
    return contact;
}

double deepest_gap(const btPersistentManifold& manifold) {
    double gap = HUGE_VAL;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        gap = std::min(gap, static_cast<double>(manifold.getContactPoint(i).getDistance()));
    }
    return gap;
}

bool active(const btPersistentManifold& manifold) {
    return manifold.getBody0()->isActive() || manifold.getBody1()->isActive();
}

std::vector<detail::Mesh> build_meshes(const std::vector<TriangleMesh>& meshes) {
    require_our_maths();
    detail::use_pool();  // must precede the first Bullet object
    std::vector<detail::Mesh> out;
    out.reserve(meshes.size());
    for (const TriangleMesh& mesh : meshes) out.emplace_back(mesh);
    return out;
}

}  // namespace

Physics::Impl::Impl(const Settings& s, const std::vector<TriangleMesh>& m)
    : settings(s), meshes(build_meshes(m)) {
    THAUM_ASSERT(s.max_bodies > 0 && s.max_bodies <= 30000, "Settings.max_bodies is not in 1..30,000");
    THAUM_ASSERT(thaum::is_finite(s.gravity), "Settings.gravity is not finite");
    THAUM_ASSERT(s.max_speed > 0 && s.max_spin > 0 && s.world_half_extent > 0,
                 "Settings.max_speed, max_spin and world_half_extent must be positive");
    bodies.reserve(s.max_bodies);
    places.assign(s.max_bodies, no_place);
    contacts.reserve(s.max_contacts);
    touching.reserve(s.max_contacts);
    touching_next.reserve(s.max_contacts);
    world = std::make_unique<detail::BulletWorld>(settings);
}

Body* Physics::Impl::find(Key key) {
    if (key < places.size()) {
        const std::uint16_t place = places[key];
        return place != no_place ? &bodies[place] : nullptr;
    }
    const auto found = std::ranges::lower_bound(bodies, key, {}, &Body::key);
    return found != bodies.end() && found->key == key ? &*found : nullptr;
}

void Physics::Impl::update_places() {
    std::ranges::fill(places, no_place);
    for (std::size_t i = 0; i < bodies.size() && bodies[i].key < places.size(); ++i)
        places[bodies[i].key] = static_cast<std::uint16_t>(i);
}

Body& Physics::Impl::at(Key key) {
    Body* const body = find(key);
    THAUM_ASSERT(body, about(key, "unknown; add it first"));
    return *body;
}

void Physics::Impl::enter_world(Body& body) {
    body.bullet = detail::make_body(body.key, body.desc, body.state, meshes, settings);
    (*world)->addRigidBody(&body.bt(), std::bit_cast<int>(body.desc.layer),
                           std::bit_cast<int>(body.desc.collides_with));
    detail::write_sleep(body.bt(), body.state);
}

void Physics::Impl::wake(Body& body) {
    if (!body.dynamic()) return;
    body.bt().activate(true);
    body.state.asleep = body.state.drowsy = 0;
    body.state.idle_s = 0;
    unchanged = false;
}

void Physics::Impl::wake_near(const Box& box) {
    for (Body& body : bodies) {
        if (body.state.asleep && overlap(box, box_around(body), resting_gap)) wake(body);
    }
}

/// Damping with rate c (1/s): v' = g - c v. With k = exp(-c dt), the velocity after a step is v0 k + g
/// (1 - k)/c, and the path is v0 (1 - k)/c + g (dt - (1 - k)/c)/c. Without damping these are v0 + g dt
/// and v0 dt + g dt^2/2.
void Physics::Impl::prepare_damping(Body& body) const {
    body.kept_velocity = det::pow(1 - body.desc.linear_damping, damping_dt);
    body.kept_spin = det::pow(1 - body.desc.angular_damping, damping_dt);
    // The damping rate c times the time step.
    const double y = -det::log(1 - body.desc.linear_damping) * damping_dt;
    if (y < 0.02) {  // Taylor series, because the differences below would lose precision
        body.drive_s = damping_dt * (1 - y / 2 * (1 - y / 3 * (1 - y / 4 * (1 - y / 5))));
        body.fall_s2 = damping_dt * damping_dt / 2 * (1 - y / 3 * (1 - y / 4 * (1 - y / 5 * (1 - y / 6))));
    } else {
        const double share = (1 - body.kept_velocity) / y;
        body.drive_s = damping_dt * share;
        body.fall_s2 = damping_dt * damping_dt * (1 - share) / y;
    }
}

void Physics::Impl::before_step(double dt) {
    if (dt != damping_dt) {
        damping_dt = dt;
        for (Body& body : bodies) prepare_damping(body);
    }
    for (Body& body : bodies) {
        body.was_asleep = body.state.asleep != 0;
        if (!body.dynamic() || body.was_asleep) continue;
        body.start_velocity = limited(body.state.velocity, settings.max_speed);
        vec3 velocity = body.start_velocity * body.kept_velocity;
        // Bullet adds gravity * dt to the velocity, but the exact law gives gravity * drive_s.
        if (settings.exact_flight) velocity += settings.gravity * (body.drive_s - dt);
        body.bt().setLinearVelocity(to_bullet(velocity));
        body.bt().setAngularVelocity(to_bullet(limited(body.state.spin, settings.max_spin) * body.kept_spin));
    }
}

/// Moves a body to the exact end of its free flight from `from`, unless something pushed it in this step.
void Physics::Impl::correct_flight(Body& body, vec3 from) const {
    const vec3 velocity = body.state.velocity;
    const vec3 free = body.start_velocity * body.kept_velocity + settings.gravity * body.drive_s;
    if (glm::length(velocity - free) > push_tolerance * (1 + glm::length(free))) return;
    // If the solver removed penetration, it changed the position but not the velocity, so both are compared.
    if (glm::length(body.state.position - (from + velocity * damping_dt)) > push_tolerance) return;
    body.state.position = from + body.start_velocity * body.drive_s + settings.gravity * body.fall_s2;
    body.bt().getWorldTransform().setOrigin(to_bullet(body.state.position));
}

/// Share of a sphere's path from start to end before it meets a static body; 1 if it meets none. A body that
/// the sphere overlaps at the start is ignored.
double Physics::Impl::free_share(const Body& moving, vec3 start, vec3 end, double radius) const {
    const double length = glm::length(end - start);
    if (length <= 0) return 1;
    detail::Path left{start, (end - start) / length, length, radius};
    for (const Body& body : bodies) {
        if (body.dynamic() || !collide(moving.desc, body.desc) || !may_touch(body, left)) continue;
        const auto contact = cast_at(body, left);
        if (contact && contact->travelled > 0) left.length = contact->travelled;
    }
    return left.length / length;
}

/// Stops a body at the wall that it would otherwise pass in this step. The solver handles the contact
/// in the next step.
void Physics::Impl::stop_at_walls(Body& body, const BodyState& from) const {
    BodyState& to = body.state;
    const detail::InnerSpheres spheres = detail::inner_spheres(body.desc);
    const double path = glm::length(to.position - from.position);
    double share = 1;
    if (path >= spheres.min_path) {
        for (const vec3& centre : spheres) {
            const vec3 start = from.position + from.orientation * centre;
            const vec3 end = to.position + to.orientation * centre;
            share = std::min(share, free_share(body, start, end, spheres.radius));
        }
    }
    // A body that tumbles over its first contact may have parts inside the wall, but its centre stays
    // outside. The solver then pushes it out to the correct side.
    const double centre_share = free_share(body, from.position, to.position, 0);
    if (centre_share < 1) share = std::clamp(centre_share - spheres.centre_gap / path, 0.0, share);
    if (share >= 1) return;
    to.position = from.position + share * (to.position - from.position);
    const double sign = glm::dot(from.orientation, to.orientation) < 0 ? -1 : 1;
    to.orientation = glm::normalize(from.orientation * (1 - share) + to.orientation * (sign * share));
    detail::write_motion(body.bt(), to);
}

/// Reads all states back from Bullet. Returns true if nothing moved.
bool Physics::Impl::after_step() {
    counters.awake = 0;
    bool still = true;
    for (Body& body : bodies) {
        if (!body.dynamic()) continue;
        const bool asleep = body.bt().getActivationState() == ISLAND_SLEEPING;
        counters.awake += !asleep;
        if (asleep && body.was_asleep) continue;
        still = false;
        const BodyState from = body.state;
        body.state = detail::read_state(body.bt());
        if (settings.exact_flight) correct_flight(body, from.position);
        if (body.desc.swept) stop_at_walls(body, from);
        body.state.velocity = limited(body.state.velocity, settings.max_speed);
        body.state.spin = limited(body.state.spin, settings.max_spin);
        tree.move(body.leaf, box_around(body));
    }
    return still;
}

void Physics::Impl::collect_contacts() {
    contacts.clear();
    touching_next.clear();
    btDispatcher& dispatcher = *(*world)->getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() == 0) continue;
        const bool before = std::ranges::binary_search(touching, pair_of(manifold));
        Contact contact{};
        const bool asleep = before && !active(manifold);
        if (!asleep) {
            contact = contact_of(manifold);
            if (!before && contact.impulse <= 0) continue;
        }
        THAUM_ASSERT(touching_next.size() < settings.max_contacts,
                     "more touching pairs than Settings.max_contacts; raise it");
        touching_next.push_back(pair_of(manifold));
        contact.began = !before;
        if (contact.impulse > 0 && active(manifold)) contacts.push_back(contact);
    }
    std::ranges::sort(touching_next);
    std::ranges::sort(contacts, {}, [](const Contact& c) { return Pair{c.a, c.b}; });
    std::swap(touching, touching_next);
}

/// Finds the pairs in contact in a new world. Sleeping bodies are included, which Bullet would leave
/// out.
void Physics::Impl::find_touching() {
    for (Body& body : bodies) {
        if (body.dynamic()) body.bt().forceActivationState(ACTIVE_TAG);
    }
    (*world)->performDiscreteCollisionDetection();
    for (Body& body : bodies) detail::write_sleep(body.bt(), body.state);
    touching.clear();
    btDispatcher& dispatcher = *(*world)->getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (deepest_gap(manifold) > touching_gap) continue;
        THAUM_ASSERT(touching.size() < settings.max_contacts,
                     "more touching pairs than Settings.max_contacts; raise it");
        touching.push_back(pair_of(manifold));
    }
    std::ranges::sort(touching);
}

Physics::Physics(const Settings& settings, const std::vector<TriangleMesh>& meshes)
    : impl_(std::make_unique<Impl>(settings, meshes)) {}

Physics::~Physics() = default;
Physics::Physics(Physics&&) noexcept = default;
Physics& Physics::operator=(Physics&&) noexcept = default;

void Physics::add(Key key, const BodyDesc& desc, const BodyState& state) {
    Impl& in = *impl_;
    THAUM_ASSERT(key != no_key, "no_key cannot be the key of a body");
    THAUM_ASSERT(in.bodies.size() < in.settings.max_bodies,
                 about(key, "more bodies than Settings.max_bodies; raise it"));
    detail::check_desc(key, desc, in.meshes.size());
    detail::check_state(key, state);
    const auto place = std::ranges::lower_bound(in.bodies, key, {}, &Body::key);
    THAUM_ASSERT(place == in.bodies.end() || place->key != key, about(key, "added twice; remove it first"));
    Body& body = *in.bodies.emplace(place);
    body.key = key;
    body.desc = desc;
    body.state = at_rest_if_asleep(state);
    body.reach = detail::reach_of(desc);
    in.prepare_damping(body);
    in.enter_world(body);
    body.leaf = in.tree.add(key, box_around(body));
    in.update_places();
    in.unchanged = false;
}

void Physics::remove(Key key) {
    Impl& in = *impl_;
    Body& body = in.at(key);
    const Box place = box_around(body);
    (*in.world)->removeRigidBody(&body.bt());
    in.tree.remove(body.leaf);
    in.bodies.erase(in.bodies.begin() + (&body - in.bodies.data()));
    in.update_places();
    std::erase_if(in.touching, [&](const Pair& pair) { return pair.a == key || pair.b == key; });
    in.unchanged = false;
    in.wake_near(place);
}

bool Physics::has(Key key) const { return impl_->find(key) != nullptr; }

const BodyDesc& Physics::desc(Key key) const { return impl_->at(key).desc; }

const BodyState& Physics::state(Key key) const { return impl_->at(key).state; }

void Physics::set_state(Key key, const BodyState& state) {
    Impl& in = *impl_;
    Body& body = in.at(key);
    detail::check_state(key, state);
    in.wake_near(box_around(body));
    body.state = at_rest_if_asleep(state);
    detail::write_motion(body.bt(), body.state);
    detail::write_sleep(body.bt(), body.state);
    in.tree.move(body.leaf, box_around(body));
    in.unchanged = false;
    if (!body.dynamic()) in.wake_near(box_around(body));
}

void Physics::set_velocity(Key key, vec3 velocity) {
    Body& body = impl_->at(key);
    THAUM_ASSERT(is_finite(velocity), about(key, "velocity is not finite"));
    if (!body.dynamic()) return;
    impl_->wake(body);
    body.state.velocity = velocity;
}

void Physics::set_spin(Key key, vec3 spin) {
    Body& body = impl_->at(key);
    THAUM_ASSERT(is_finite(spin), about(key, "spin is not finite"));
    if (!body.dynamic() || body.desc.upright) return;
    impl_->wake(body);
    body.state.spin = spin;
}

void Physics::apply_impulse(Key key, vec3 impulse, vec3 point) {
    Body& body = impl_->at(key);
    THAUM_ASSERT(is_finite(impulse) && is_finite(point), about(key, "impulse is not finite"));
    if (!body.dynamic()) return;
    impl_->wake(body);
    body.state.velocity += impulse / body.desc.mass;
    THAUM_ASSERT(is_finite(body.state.velocity), about(key, "impulse makes the velocity infinite"));
    if (body.desc.upright) return;
    const vec3 twist = glm::cross(point - body.state.position, impulse);
    body.state.spin += from_bullet(body.bt().getInvInertiaTensorWorld() * to_bullet(twist));
    THAUM_ASSERT(is_finite(body.state.spin), about(key, "impulse makes the velocity infinite"));
}

void Physics::apply_central_impulse(Key key, vec3 impulse) {
    apply_impulse(key, impulse, impl_->at(key).state.position);
}

void Physics::nudge(Key key, vec3 impulse) {
    Body& body = impl_->at(key);
    THAUM_ASSERT(is_finite(impulse), about(key, "impulse is not finite"));
    if (body.dynamic() && !body.state.asleep) body.state.velocity += impulse / body.desc.mass;
}

void Physics::wake(Key key) { impl_->wake(impl_->at(key)); }

void Physics::step(double dt) {
    Impl& in = *impl_;
    THAUM_ASSERT(std::isfinite(dt) && dt > 0, "the time of a step must be > 0");
    ++in.counters.steps;
    in.skipped = in.unchanged && in.settings.skip_asleep;
    if (in.skipped) {
        // The contacts are empty already, because no body was awake in the last step either.
        ++in.counters.skipped;
        return;
    }
    in.before_step(dt);
    (*in.world)->stepSimulation(dt, 0);
    in.unchanged = in.after_step();
    in.collect_contacts();
}

bool Physics::skipped_last_step() const { return impl_->skipped; }

std::span<const Contact> Physics::contacts() const { return impl_->contacts; }

void Physics::rebuild() {
    Impl& in = *impl_;
    in.world.reset();
    for (Body& body : in.bodies) body.bullet = {};
    in.world = std::make_unique<detail::BulletWorld>(in.settings);
    for (Body& body : in.bodies) in.enter_world(body);
    in.find_touching();
    in.contacts.clear();
    in.unchanged = false;
}

Counters Physics::counters() const {
    Counters counters = impl_->counters;
    counters.bodies = static_cast<std::uint32_t>(impl_->bodies.size());
    return counters;
}

const Settings& Physics::settings() const { return impl_->settings; }

}  // namespace thaum::physics
