#include "haptics/simulated.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"

namespace thaum::haptics {
namespace {

/// Largest number of times that dry friction may stop or release an axis within one tick. A constant force
/// and an evenly moving target allow three at most. After the last one the axis is held until the tick ends.
constexpr int max_phases = 8;
constexpr int max_refinements = 60;

/// State of one axis at some moment of a tick.
struct Axis {
    double position, velocity;
    double target, target_velocity;
    double force;  // force on the tip, constant within the tick (N)
};

/// Force on the body without dry friction (N).
double load(const SimulatedDevice& d, const Axis& a) {
    return a.force + d.stiffness * (a.target - a.position) +
           d.hand_damping * (a.target_velocity - a.velocity) - d.damping * a.velocity;
}

/// Motion of an axis in one direction. Dry friction is constant during it, so the equation of motion is
/// linear.
struct SlidePhase {
    const SimulatedDevice& device;
    double velocity, acceleration;  // velocity and acceleration at the start of the phase (m/s, m/s^2)
    double target_velocity;

    double velocity_at(const Response& r) const {
        return velocity + r.s * acceleration +
               device.oscillator.frequency2 * r.s1 * (target_velocity - velocity);
    }
    double acceleration_at(const Response& r) const {
        return slope(device.oscillator, r) * acceleration +
               device.oscillator.frequency2 * r.s * (target_velocity - velocity);
    }
    double jerk_at(const Response& r) const {
        return -2 * device.oscillator.decay * acceleration_at(r) -
               device.oscillator.frequency2 * (velocity_at(r) - target_velocity);
    }
    double path(const Response& r) const {
        return r.t * velocity + r.s1 * acceleration +
               device.oscillator.frequency2 * r.s2 * (target_velocity - velocity);
    }
};

struct Value {
    double value, slope;
};

/// Finds the zero of a function between low and high, where its values have different signs. Newton's method,
/// with bisection where a step would leave the bracket. It ends with a step below 1e-10 of the bracket. Since
/// it converges quadratically, the error is then about the square of that.
template <class Of>
double root(Of of, double low, double high, bool positive_at_low, double guess) {
    const double small = 1e-10 * (high - low);
    double at = guess > low && guess < high ? guess : (low + high) / 2;
    for (int i = 0; i < max_refinements; ++i) {
        const Value f = of(at);
        ((f.value > 0) == positive_at_low ? low : high) = at;
        const double next = at - f.value / f.slope;
        if (std::abs(next - at) <= small) return std::clamp(next, low, high);
        at = next >= low && next <= high ? next : (low + high) / 2;  // NaN fails both comparisons, so it
                                                                     // bisects
    }
    return at;
}

double turning_point(const SlidePhase& s, double end) {
    const auto of = [&s](double t) {
        const Response r = response(s.device.oscillator, t);
        return Value{s.acceleration_at(r), s.jerk_at(r)};
    };
    return root(of, 0, end, s.acceleration > 0, end / 2);
}

double standstill(const SlidePhase& s, double begin, double end, double direction) {
    const auto of = [&s](double t) {
        const Response r = response(s.device.oscillator, t);
        return Value{s.velocity_at(r), s.acceleration_at(r)};
    };
    return root(of, begin, end, direction > 0, -s.velocity / s.acceleration);
}

/// Returns the time at which a slide in `direction` first stops (s), or a negative number if it does not stop
/// before the end of the tick, at which the oscillator's response is `whole`. The velocity turns at most once
/// in so short a time. So there are three cases: the velocity changes sign; it dips below zero and comes
/// back; it does neither.
double stop_time(const SlidePhase& s, const Response& whole, double direction) {
    const bool crossed = s.velocity_at(whole) * direction < 0;
    const bool starts_by_falling = s.acceleration * direction < 0;
    if (crossed) {
        const double begin = s.velocity == 0 ? turning_point(s, whole.t) : 0;
        return standstill(s, begin, whole.t, direction);
    }
    if (!starts_by_falling || s.acceleration_at(whole) * direction <= 0) return -1;
    const double lowest = turning_point(s, whole.t);
    if (s.velocity_at(response(s.device.oscillator, lowest)) * direction >= 0) return -1;
    return standstill(s, 0, lowest, direction);
}

void move(Axis& a, const SlidePhase& s, const Response& r) {
    a.position += s.path(r);
    a.velocity = s.velocity_at(r);
    a.target += a.target_velocity * r.t;
}

/// Returns the time for which dry friction holds a resting body while the target moves (s). The load must be
/// within the friction's limits.
double holding_time(const SimulatedDevice& d, const Axis& a, double left) {
    const double rate = d.stiffness * a.target_velocity;
    if (rate == 0) return left;
    const double limit = rate > 0 ? d.friction : -d.friction;
    return std::min((limit - load(d, a)) / rate, left);
}

void hold(Axis& a, double time) { a.target += a.target_velocity * time; }

/// Slides to the next stop or to the end of the tick. Returns the time that is left (s).
double slide_on(const SimulatedDevice& d, Axis& a, double direction, double acceleration, double left) {
    const SlidePhase s{d, a.velocity, acceleration, a.target_velocity};
    const Response whole = left == d.dt ? d.tick : response(d.oscillator, left);
    const double stop = stop_time(s, whole, direction);
    if (stop < 0) {
        move(a, s, whole);
        return 0;
    }
    move(a, s, response(d.oscillator, stop));
    a.velocity = 0;
    return left - stop;
}

void advance_with_friction(const SimulatedDevice& d, Axis& a) {
    double left = d.dt;
    for (int phase = 0; phase < max_phases && left > 0; ++phase) {
        if (a.velocity != 0) {
            const double direction = a.velocity > 0 ? 1 : -1;
            left = slide_on(d, a, direction, (load(d, a) - direction * d.friction) / d.mass, left);
            continue;
        }
        const double pull = load(d, a);
        if (std::abs(pull) > d.friction) {
            const double direction = pull > 0 ? 1 : -1;
            left = slide_on(d, a, direction, (pull - direction * d.friction) / d.mass, left);
            continue;
        }
        const double held = holding_time(d, a, left);
        hold(a, held);
        left -= held;
        // At the moment of release, load and dry friction cancel. Their rounding error must not start the
        // body backwards, so the acceleration is set to 0.
        if (left > 0) left = slide_on(d, a, a.target_velocity > 0 ? 1 : -1, 0, left);
    }
    if (left > 0) hold(a, left);
}

void advance(const SimulatedDevice& d, Axis& a) {
    if (d.friction > 0) return advance_with_friction(d, a);
    move(a, {d, a.velocity, load(d, a) / d.mass, a.target_velocity}, d.tick);
}

/// Returns the command of `latency` ticks ago, and stores the new one.
vec3 delayed(const SimulatedDevice& d, SimulatedState& state, vec3 command) {
    if (d.latency == 0) return command;
    auto& queue = state.commanded;
    const vec3 due = queue[0];
    const auto last = static_cast<std::size_t>(d.latency) - 1;
    for (std::size_t i = 0; i < last; ++i) queue[i] = queue[i + 1];
    queue[last] = command;
    return due;
}

vec3 saturated(vec3 force, double most) {
    if (!is_finite(force)) return {};
    // Scales by the largest component first, because the length of a huge vector overflows.
    const double largest = std::max({std::abs(force.x), std::abs(force.y), std::abs(force.z)});
    if (largest > most) force *= most / largest;
    return limited(force, most);
}

vec3 next_target(const SimulatedDevice& d, vec3 current, vec3 wanted) {
    if (!is_finite(wanted)) return current;
    return current + limited(glm::clamp(wanted, -d.reach, d.reach) - current, d.target_step);
}

void stop_at_the_ends(double& position, double& velocity, double reach) {
    if (std::abs(position) <= reach) return;
    position = position > 0 ? reach : -reach;
    if (position * velocity > 0) velocity = 0;
}

}  // namespace

SimulatedDevice simulated_device(const DeviceSpec& spec, const Hand& hand, double dt) {
    SimulatedDevice d{.mass = spec.mass + hand.mass,
                      .stiffness = hand.stiffness,
                      .hand_damping = hand.damping,
                      .damping = spec.damping,
                      .friction = spec.coulomb_friction,
                      .peak_force = spec.peak_force,
                      .quantum = spec.position_quantum,
                      .reach = spec.workspace / 2.0,
                      .target_step = hand.max_target_speed * dt,
                      .latency = spec.latency,
                      .dt = dt};
    THAUM_ASSERT(d.mass > 0 && dt > 0, "a simulated device needs a mass and a tick");
    THAUM_ASSERT(d.latency >= 0 && d.latency <= max_latency, "a simulated device cannot be so late");
    d.oscillator = oscillator(d.mass, d.hand_damping + d.damping, d.stiffness);
    THAUM_ASSERT(d.oscillator.frequency2 * dt * dt <= 9, "the hand is too stiff for its mass");
    d.tick = response(d.oscillator, dt);
    return d;
}

SimulatedState resting_at(vec3 position) { return {.position = position, .target = position}; }

vec3 measured_position(const SimulatedDevice& device, const SimulatedState& state) {
    if (device.quantum == 0) return state.position;
    return device.quantum * glm::floor(state.position / device.quantum + 0.5);
}

SimulatedState step(const SimulatedDevice& d, const SimulatedState& before, vec3 target, vec3 force) {
    SimulatedState after = before;
    after.force = delayed(d, after, saturated(force, d.peak_force));
    after.target = next_target(d, before.target, target);
    const vec3 target_velocity = (after.target - before.target) / d.dt;
    for (int i = 0; i < 3; ++i) {
        Axis axis{before.position[i], before.velocity[i], before.target[i], target_velocity[i],
                  after.force[i]};
        advance(d, axis);
        after.position[i] = axis.position;
        after.velocity[i] = axis.velocity;
        stop_at_the_ends(after.position[i], after.velocity[i], d.reach[i]);
    }
    return after;
}

double energy(const SimulatedDevice& device, const SimulatedState& state) {
    const vec3 stretch = state.target - state.position;
    return (device.mass * glm::dot(state.velocity, state.velocity) +
            device.stiffness * glm::dot(stretch, stretch)) /
           2;
}

}  // namespace thaum::haptics
