// game/components/arm.h: state of a real force feedback arm in a match, and past haptic models that the arm's
// thread may still be using. Each component stands on an entity of its own. A match without a real arm has
// none of them.
#pragma once
#include "ecs/component.h"
#include "game/components/hand_state.h"
#include "input/arm_servo.h"

namespace thaum::input {

THAUM_FIELDS_OF(ArmState, servo, hand, offset, rest, position_um, rotation_urad, epoch, number, samples,
                without, old_poses, gaps, rests, spare)

}  // namespace thaum::input

namespace thaum::game::inline components {

/// A real arm (force-feedback device) held by one player.
struct Arm {
    /// State of the arm's force computation (servo) in the simulation. The arm's own thread has an equal
    /// copy, because both threads compute the same steps from the same samples.
    input::ArmState state{};
    /// Entities of the past haptic models (from which the servo computes forces), as a ring buffer: model n
    /// is at index n modulo the size.
    std::array<ecs::Entity, input::remembered_models> models{};
    std::uint32_t player{};
    std::uint32_t device{};  ///< index of the arm among the match's devices
    /// Ticks for which further haptic models still carry the press of the panic key. The press is repeated
    /// because the arm's thread may skip a model.
    std::uint32_t panic_left{};
    std::uint32_t rearm_left{};  ///< ticks for which further haptic models still carry the press that
                                 ///< switches forces on again
    std::uint32_t away{};        ///< 1 from the loss of the arm until it is connected again and has been held
                                 ///< still; otherwise 0
    std::uint32_t still{};       ///< ticks for which the arm has been held still
    /// Position about which the arm is held still (um, device frame).
    std::array<std::int32_t, 3> still_um{};
    std::uint32_t spare{};
    THAUM_COMPONENT(Arm, state, models, player, device, panic_left, rearm_left, away, still, still_um, spare);
};

/// One published haptic model (haptics::HapticModel), the description from which the arm's thread computes
/// forces. It is kept because the arm may still send a sample computed with it. The model is stored as raw
/// bytes, because only the servo reads it. A model has no padding (haptics/servo.h).
struct PastModel {
    static_assert(sizeof(haptics::HapticModel) % sizeof(std::uint64_t) == 0);
    static constexpr std::size_t words = sizeof(haptics::HapticModel) / sizeof(std::uint64_t);

    std::array<std::uint64_t, words> bytes{};
    vec3 offset{};
    std::uint32_t number{};
    std::uint32_t samples{};
    THAUM_COMPONENT(PastModel, bytes, offset, number, samples);
};

}  // namespace thaum::game::inline components
