#include "game/scenario/script_arm.h"

namespace thaum::game::inline scenario {
namespace {

constexpr double micrometres_per_metre = 1e6;
constexpr std::int64_t ns_per_tick = 1'000'000;

void move_on(ScriptArm& arm) {
    const vec3 way = arm.to - arm.at;
    const double distance = glm::length(way);
    const bool there = arm.step <= 0 || distance <= arm.step * (1 + 1e-9);
    arm.at = there ? arm.to : arm.at + way * (arm.step / distance);
}

}  // namespace

void step_arms(ScriptArms& arms) {
    for (const auto& arm : arms) {
        if (!arm) continue;
        move_on(*arm);
        arm->time_ns += ns_per_tick;
        input::ArmReading reading{.time_ns = arm->time_ns};
        for (int axis = 0; axis < 3; ++axis)
            reading.position_um[static_cast<std::size_t>(axis)] =
                input::quantised(arm->at[axis] * micrometres_per_metre);
        arm->told = arm->servo.step(reading);
    }
}

void take_samples(ScriptArms& arms, input::InputFrame& frame) {
    for (const auto& arm : arms)
        if (arm) frame.devices[arm->device] = arm->servo.take();
}

std::uint64_t differing_forces(const ScriptArms& arms) {
    std::uint64_t count = 0;
    for (const auto& arm : arms)
        if (arm) count += arm->servo.faults().differing;
    return count;
}

}  // namespace thaum::game::inline scenario
