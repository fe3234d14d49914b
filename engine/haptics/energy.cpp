#include "haptics/energy.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "haptics/safety.h"

namespace thaum::haptics {
namespace {

constexpr double still = 1e-6;  // m/s; below this speed, damping takes out no energy
constexpr std::uint32_t kept = most_latency + 1;
/// Share of the active sources' budget in which their force fades.
constexpr double fading_share = 0.2;
/// Force with which a spring without any reserve meets a hand that presses in (N): a force of zero would never
/// receive anything.
constexpr double least_force = 0.1;
static_assert((active_bins - 2) * active_bin_ticks == ticks(1));

/// Largest sum of the work from any tick that the bins hold until now.
double largest_active_work(const PassivityObserver& observer) {
    const std::size_t oldest = (observer.active_bin + 1) % active_bins;
    double most = 0, later = 0;
    for (std::size_t back = 0; back + 1 < active_bins; ++back) {
        const ActiveBin& bin = observer.active[(observer.active_bin + active_bins - back) % active_bins];
        most = std::max(most, later + bin.most);
        later += bin.sum;
    }
    const double left = 1 - (observer.active_tick + 1.0) / active_bin_ticks;
    return most + left * std::max(0.0, later + observer.active[oldest].most - most);
}

/// Adds the work of active sources in one tick (J).
void add_active_work(PassivityObserver& observer, double work) {
    ActiveBin& bin = observer.active[observer.active_bin];
    bin.sum += work;
    bin.most = std::max(0.0, bin.most + work);
    if (work != 0 || observer.active_work != 0) observer.active_work = largest_active_work(observer);
    if (++observer.active_tick < active_bin_ticks) return;
    observer.active_tick = 0;
    observer.active_bin = static_cast<std::uint32_t>((observer.active_bin + 1) % active_bins);
    observer.active[observer.active_bin] = {};
}

/// Adds the energy that springs gave to what they have left.
void use_reserve(PassivityObserver& observer, double given, double stored) {
    if (observer.held_back == 0) return;
    const double most = stored + std::clamp(reserve_energy - observer.created, 0.0, reserve_energy);
    observer.reserve = std::clamp(observer.reserve - given, 0.0, most);
}

}  // namespace

void observe(PassivityObserver& observer, vec3 position, vec3 world_step, double stored, int latency,
             double supplied) {
    if (!is_finite(position) || !is_finite(world_step) || !std::isfinite(supplied)) {
        observer.has_position = 0;
        return;
    }
    const vec3 step = position - observer.position;
    if (observer.has_position != 0 && glm::length(step) <= longest_step) {
        const auto back = static_cast<std::uint32_t>(std::clamp(latency, 0, most_latency));
        const auto& force = observer.forces[(observer.newest + kept - back) % kept];
        const double given = glm::dot(force.passive, step) - glm::dot(force.world, world_step) -
                             observer.forces[observer.newest].share * supplied;
        observer.created += given;
        use_reserve(observer, given, stored);
        // Damping has dissipated the rest; only stored energy can come back.
        observer.created = std::max(observer.created, -stored);
        observer.most_created = std::max(observer.most_created, observer.created);
        add_active_work(observer, glm::dot(force.active, step));
    }
    observer.position = position;
    observer.has_position = 1;
}

double surplus(const PassivityObserver& observer, double held) {
    return std::max(observer.created, observer.created + held - energy_slack);
}

vec3 passivity_control(double energy, vec3 velocity, double most) {
    const double speed = glm::length(velocity);
    if (!(energy > 0) || !(speed > still) || !std::isfinite(speed)) return vec3(0);
    return -std::min(energy / (speed * speed * tick_seconds), most) * velocity;
}

vec3 steady_brake(PassivityObserver& observer, vec3 wished, double most) {
    observer.brake = limited(observer.brake + limited(wished - observer.brake, brake_step), most);
    return observer.brake;
}

double pending_work(const PassivityObserver& observer, vec3 step, int latency) {
    double work = 0;
    for (int back = 0; back < std::min(latency, most_latency); ++back)
        work += glm::dot(
            observer.forces[(observer.newest + kept - static_cast<std::uint32_t>(back)) % kept].passive,
            step);
    return work;
}

vec3 within_budget(const PassivityObserver& observer, vec3 active) {
    constexpr double fading = fading_share * active_budget;
    const double left = active_budget - observer.active_work;
    return left >= fading ? active : std::max(0.0, left / fading) * active;
}

double fade_energy(const PassivityObserver& observer) {
    // Springs may still give their reserve. What they have received since does not pay for another fade.
    return std::clamp(reserve_energy + switch_energy - (observer.created + observer.reserve), 0.0,
                      switch_energy);
}

void hold_back(PassivityObserver& observer) {
    const double running = observer.held_back != 0 ? observer.reserve : 0;
    observer.held_back = 1;
    observer.reserve = std::max(running, reserve_energy - observer.created);
}

void forgive(PassivityObserver& observer, bool springs_pull) {
    // Time constants with which a large debt, and that of a hand that feels no spring, are forgotten (s).
    constexpr double soon = 2, slowly = 20;
    observer.created -= std::max(0.0, observer.created - 2 * reserve_energy) * (tick_seconds / soon);
    if (!springs_pull) observer.created -= std::max(0.0, observer.created) * (tick_seconds / slowly);
}

void release_if_covered(PassivityObserver& observer, const HeldSprings& springs, double stiffness) {
    if (observer.held_back == 0 || !(stiffness > 0)) return;
    // A spring of the device's stiffness receives a little less than it holds, a tick's motion times its force.
    constexpr double nearly = 0.8, settled = 1e-6;
    const double pull = springs.pull;
    const double owed = std::max(springs.energy - energy_slack, nearly * pull * pull / (2 * stiffness));
    const bool may_push = springs.may_lie_ahead || observer.created > settled;
    if (pull > 0 ? observer.created + owed > 0 : may_push) return;
    observer.held_back = 0;
    observer.reserve = 0;
}

double force_of_reserve(const PassivityObserver& observer, double outward, double pending, double stiffness) {
    if (observer.held_back == 0 || !(stiffness > 0)) return HUGE_VAL;
    const double left = std::max(0.0, observer.reserve - std::max(0.0, pending));
    const double ahead = stiffness * outward;
    if (ahead < 0) return std::max(std::sqrt(2 * stiffness * left), std::min(-ahead, least_force));
    return std::max(0.0, std::sqrt(2 * stiffness * left) - ahead);
}

// Cap and heat scale all sources alike. The fading offset of a switch returns energy that was received and hardly any
// more, since the reserve limits it. It is therefore passive, like the controller's brake.
void record_output(PassivityObserver& observer, vec3 output, vec3 passive, vec3 active, vec3 world,
                   vec3 unrequested) {
    const vec3 wanted = passive + active;
    const double size2 = glm::dot(wanted, wanted);
    const double share = size2 > 0 ? std::clamp(glm::dot(output - unrequested, wanted) / size2, 0.0, 1.0) : 0;
    const bool sane = is_finite(passive) && is_finite(active) && is_finite(world) && is_finite(unrequested) &&
                      std::isfinite(share);
    observer.newest = (observer.newest + 1) % kept;
    auto& force = observer.forces[observer.newest];
    force.share = sane ? share : 0;
    force.passive = sane ? share * passive + unrequested : vec3(0);
    force.world = sane ? share * world : vec3(0);
    force.active = output - force.passive;
}

void record_ramp(PassivityObserver& observer, vec3 output) {
    const CommandedForce last = observer.forces[observer.newest];
    const vec3 before = last.passive + last.active;
    const double size2 = glm::dot(before, before);
    const double left = size2 > 0 ? std::clamp(glm::dot(output, before) / size2, 0.0, 1.0) : 0;
    observer.newest = (observer.newest + 1) % kept;
    const vec3 active = std::isfinite(left) ? left * last.active : vec3(0);
    observer.forces[observer.newest] = {.passive = output - active, .active = active};
}

}  // namespace thaum::haptics
