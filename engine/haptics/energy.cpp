#include "haptics/energy.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace thaum::haptics {
namespace {

constexpr double still = 1e-6;  // m/s; below this speed, damping takes out no energy
constexpr std::uint32_t kept = most_latency + 1;

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
        observer.created += glm::dot(force.passive, step) - glm::dot(force.world, world_step) -
                            observer.forces[observer.newest].share * supplied;
        // Damping has dissipated the rest; only stored energy can come back.
        observer.created = std::max(observer.created, -stored);
        observer.most_created = std::max(observer.most_created, observer.created);
        observer.active_work += glm::dot(force.active, step) - observer.active_work * tick_seconds;
        observer.active_work = std::max(observer.active_work, 0.0);
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

double pending_work(const PassivityObserver& observer, vec3 step, int latency) {
    double work = 0;
    for (int back = 0; back < std::min(latency, most_latency); ++back)
        work += glm::dot(
            observer.forces[(observer.newest + kept - static_cast<std::uint32_t>(back)) % kept].passive,
            step);
    return work;
}

vec3 within_budget(const PassivityObserver& observer, vec3 active, vec3 velocity) {
    const double speed = glm::length(velocity);
    if (observer.active_work <= active_budget || !(speed > still) || !std::isfinite(speed)) return active;
    const vec3 way = velocity / speed;
    return active - std::max(0.0, glm::dot(active, way)) * way;
}

// Cap and heat scale all sources alike. The fading offset of a switch returns the energy that it received and
// hardly any more. It is therefore passive, like the controller's brake. The rest is the ramp of an old
// model, which is no spring, and counts as active.
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

}  // namespace thaum::haptics
