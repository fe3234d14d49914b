#include "game/context/arms.h"

namespace thaum::game::inline context {
namespace {

/// Ticks without a sample after which a real arm (force-feedback device) counts as gone, so that the
/// simulated hand takes over.
constexpr std::uint32_t gone_after = 250;

}  // namespace

bool is_gone(const Arm& arm) { return arm.state.without >= gone_after; }

const Arm* arm_of(const ecs::World& world, std::uint32_t player) {
    const Arm* found = nullptr;
    world.view<const Arm>().each([&](const Arm& arm) {
        if (arm.player == player) found = &arm;
    });
    return found;
}

ArmCondition arm_condition(const ecs::World& world, std::uint32_t player) {
    const auto* arm = arm_of(world, player);
    if (arm == nullptr) return ArmCondition::none;
    if (is_gone(*arm)) return ArmCondition::gone;
    if (arm->away != 0) return ArmCondition::back;
    return arm->state.rests != 0 ? ArmCondition::clutched : ArmCondition::felt;
}

vec3 stylus_turn(const ecs::World& world, std::uint32_t player) {
    constexpr double rad_per_urad = 1e-6;
    const auto* arm = arm_of(world, player);
    if (arm == nullptr || is_gone(*arm)) return vec3(0);
    const auto& urad = arm->state.rotation_urad;
    return limited(vec3(urad[0], urad[1], urad[2]) * rad_per_urad, pi);
}

bool plays_by_arm(const ecs::World& world, std::uint32_t player) {
    const auto* arm = arm_of(world, player);
    return arm != nullptr && !is_gone(*arm);
}

}  // namespace thaum::game::inline context
