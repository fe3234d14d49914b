#include "physics/mover.h"

#include <algorithm>

#include "core/assert.h"
#include "core/text.h"

namespace thaum::physics {
namespace {

constexpr vec3 up{0, 1, 0};
/// The ground is found by a sphere that is swept down from the mover's capsule. Its radius is smaller than
/// the capsule's by this, so that walls do not stop it (m).
constexpr double sole = 0.02;
/// Largest speed away from the ground at which a falling mover (the capsule of a person) counts as landed
/// (m/s).
constexpr double caught_speed = 1;
/// Largest speed away from the ground at which a walking mover is kept on the ground, as over a crest of 50
/// degrees (m/s).
constexpr double held_speed = 4;
constexpr double noticed_force = 50;  // smallest loss of driving force that counts as resistance (N)
constexpr double still = 1e-6;        // changes of velocity below this are ignored (m/s)

struct Ground {
    Key key;
    vec3 normal;
    vec3 velocity;  ///< velocity of the ground at the point of contact (m/s)
};

vec3 level(vec3 v) { return {v.x, 0, v.z}; }

vec3 along(vec3 v, vec3 normal) { return v - normal * glm::dot(v, normal); }

std::optional<Ground> find_ground(const Physics& physics, Key key, const MoverSettings& settings) {
    const BodyDesc& desc = physics.desc(key);
    const vec3 foot = physics.state(key).position - desc.size.y * up;
    // The sphere that is swept down is thinner than the capsule. On a slope it must therefore go farther down
    // than on level ground, by a factor of 1 / cos.
    const double down = sole / settings.steepest_cos + settings.reach;
    const auto hit = physics.sweep_sphere(foot, foot - down * up, desc.size.x - sole, settings.ground, key);
    if (!hit || hit->normal.y < settings.steepest_cos) return std::nullopt;
    if (hit->fraction * down > sole / hit->normal.y + settings.reach) return std::nullopt;
    return Ground{hit->key, hit->normal, velocity_at(physics.state(hit->key), hit->point)};
}

/// The wished velocity, tilted into the plane of the ground, with the same speed as on level ground.
vec3 wish_along(vec3 wish, vec3 normal) {
    const double speed = glm::length(wish);
    if (speed == 0) return {};
    // The velocity is tilted, not projected, so that its direction seen from above does not change.
    const vec3 tilted = wish - up * (glm::dot(wish, normal) / normal.y);
    return tilted * (speed / glm::length(tilted));
}

/// The wished velocity relative to the ground. Loose ground that slides ahead, perhaps because the mover has
/// kicked its edge, must not make the mover faster than walking: the sum of both velocities is at most the
/// walking speed, or the speed that the mover already has.
vec3 wish_on(const Physics& physics, Key key, const Ground& ground, vec3 wish,
             const MoverSettings& settings) {
    const vec3 carried = level(ground.velocity);
    if (physics.desc(ground.key).mass <= 0 || carried == vec3{}) return wish;
    const double most = std::max(settings.walk_speed, glm::length(level(physics.velocity(key))));
    return limited(carried + wish, most) - carried;
}

/// Whether something resisted the last change of velocity that the mover made in this direction.
bool resisted(const MoverState& state, vec3 current, vec3 direction, double mass, double dt) {
    return state.driven && glm::dot(state.expected - current, direction) * mass > noticed_force * dt;
}

/// Change of velocity towards the wished velocity, in the plane of the ground, in this step.
vec3 drive(const MoverSettings& settings, const MoverState& state, vec3 target, vec3 current, double mass,
           double dt) {
    const vec3 missing = target - current;
    const double size = glm::length(missing);
    if (size <= still) return {};
    const double free = settings.ground_acceleration * dt;
    const double pushing = settings.push_force / mass * dt;
    return limited(missing,
                   resisted(state, current, missing / size, mass, dt) ? std::min(free, pushing) : free);
}

/// Share of the weight that rests on the ground, 0 to 1; traction is proportional to it.
double traction(const Physics& physics, Key key, double rope_lift) {
    const double weight = physics.desc(key).mass * glm::length(physics.settings().gravity);
    return weight > 0 ? std::clamp(1 - rope_lift / weight, 0.0, 1.0) : 1;
}

void walk(Physics& physics, Key key, const Ground& ground, vec3 wish, MoverSettings settings, double traction,
          MoverState& state, double dt) {
    const double mass = physics.desc(key).mass;
    settings.ground_acceleration *= traction;
    settings.push_force *= traction;
    settings.adhesion *= traction;
    const vec3 relative = physics.velocity(key) - ground.velocity;
    const vec3 current = along(relative, ground.normal);
    const vec3 target = wish_along(wish_on(physics, key, ground, wish, settings), ground.normal);
    const vec3 change = drive(settings, state, target, current, mass, dt);
    const double leaving = std::max(0.0, glm::dot(relative, ground.normal));
    const vec3 down = ground.normal * -std::min(leaving, settings.adhesion * dt);
    const vec3 uphill = -along(physics.settings().gravity, ground.normal) * (traction * dt);
    physics.nudge(key, mass * (change + down + uphill));
    state.expected = current + change;
    state.driven = 1;
}

/// Accelerates a mover in the air towards the wished velocity, never beyond it. A motion that is faster along
/// the wish is not braked.
void fly(Physics& physics, Key key, vec3 wish, const MoverSettings& settings, double dt) {
    const double speed = glm::length(wish);
    if (speed == 0) return;
    const vec3 missing = wish - level(physics.velocity(key));
    if (glm::dot(missing, wish) <= 0) return;
    physics.nudge(key, physics.desc(key).mass * limited(missing, settings.air_acceleration * dt));
}

void jump(Physics& physics, Key key, const Ground& ground, const MoverSettings& settings) {
    const double rising = physics.velocity(key).y - ground.velocity.y;
    physics.apply_central_impulse(
        key, up * (physics.desc(key).mass * std::max(0.0, settings.jump_speed - rising)));
}

bool leaves(const Physics& physics, Key key, const Ground& ground, const MoverState& state) {
    const double away = glm::dot(physics.velocity(key) - ground.velocity, ground.normal);
    return away > (state.grounded ? held_speed : caught_speed);
}

MoverResult asleep(const MoverState& state) {
    return {.grounded = state.grounded != 0, .ground_normal = state.ground_normal};
}

/// Speed of a landing. Uses the last falling speed as well, because a hard landing may already have stopped
/// the body within the step before the ground is found.
double landing_speed(vec3 velocity, const Ground& ground, const MoverState& state) {
    return std::max(0.0, std::max(state.falling, -velocity.y) + ground.velocity.y);
}

void take_off(MoverState& state) {
    state.grounded = state.driven = 0;
    state.ground_normal = up;
}

}  // namespace

MoverResult move(Physics& physics, Key key, const MoverInput& input, const MoverSettings& settings,
                 MoverState& state, double dt) {
    THAUM_ASSERT(is_finite(input.wish_velocity), text("body ", key, ": wish is not finite"));
    const vec3 wish = limited(level(input.wish_velocity), settings.walk_speed);
    if (wish != vec3{} || input.jump) {
        if (physics.state(key).asleep) physics.wake(key);
    } else if (physics.state(key).asleep) {
        return asleep(state);
    }

    const auto ground = find_ground(physics, key, settings);
    const double traction_left = traction(physics, key, input.rope_lift);
    if (!ground || traction_left == 0 || leaves(physics, key, *ground, state)) {
        take_off(state);
        state.falling = std::max(0.0, -physics.velocity(key).y);
        fly(physics, key, wish, settings, dt);
        return {};
    }

    MoverResult result{.grounded = true, .ground_normal = ground->normal, .ground = ground->key};
    if (!state.grounded) result.landing_speed = landing_speed(physics.velocity(key), *ground, state);
    state.grounded = 1;
    state.ground_normal = ground->normal;
    state.falling = 0;
    if (input.jump) {
        jump(physics, key, *ground, settings);
        take_off(state);
        result.grounded = false;
        result.jumped = true;
        return result;
    }
    walk(physics, key, *ground, wish, settings, traction_left, state, dt);
    return result;
}

}  // namespace thaum::physics
