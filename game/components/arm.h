// game/components/arm.h: a real force feedback arm in a player's hand, as the match knows it, and the models that it made for it.
// Entities of their own; there are none where nobody holds an arm.
#pragma once
#include "ecs/component.h"
#include "game/components/grip.h"
#include "input/arm_servo.h"

namespace thaum::input {

constexpr auto fields_of(const ArmState*) {
    using S = ArmState;
    return std::tuple(
        ecs::field("servo", &S::servo), ecs::field("hand", &S::hand), ecs::field("offset", &S::offset),
        ecs::field("rest", &S::rest), ecs::field("position_um", &S::position_um),
        ecs::field("rotation_urad", &S::rotation_urad), ecs::field("epoch", &S::epoch),
        ecs::field("number", &S::number), ecs::field("samples", &S::samples),
        ecs::field("without", &S::without), ecs::field("old_poses", &S::old_poses),
        ecs::field("gaps", &S::gaps), ecs::field("rests", &S::rests), ecs::field("spare", &S::spare));
}

}  // namespace thaum::input

namespace thaum::game {

using ecs::field;

struct Arm {
    input::ArmState state{};
    std::array<ecs::Entity, input::models_kept> models{};  ///< model n is in place n mod size
    std::uint32_t player{};
    std::uint32_t device{};  ///< whose samples
    std::uint32_t
        panic_left{};  ///< ticks in which models tell of a panic: the arm does not take up each of them
    std::uint32_t rearm_left{};              ///< likewise
    std::uint32_t away{};                    ///< 1 from when it is gone until it is back and was held still
    std::uint32_t still{};                   ///< ticks for which it was
    std::array<std::int32_t, 3> still_um{};  ///< where
    std::uint32_t spare{};
    static constexpr std::string_view name = "Arm";
    static constexpr auto fields() {
        return std::tuple(field("state", &Arm::state), field("models", &Arm::models),
                          field("player", &Arm::player), field("device", &Arm::device),
                          field("panic_left", &Arm::panic_left), field("rearm_left", &Arm::rearm_left),
                          field("away", &Arm::away), field("still", &Arm::still),
                          field("still_um", &Arm::still_um), field("spare", &Arm::spare));
    }
};

/// A haptics::HapticModel as it was published: a sample that was felt by it is still on its way. Its bytes, since it is what it is
/// to the servo alone; those that are no part of a value are zero.
struct PastModel {
    static_assert(sizeof(haptics::HapticModel) % sizeof(std::uint64_t) == 0);
    static constexpr std::size_t words = sizeof(haptics::HapticModel) / sizeof(std::uint64_t);

    std::array<std::uint64_t, words> bytes{};
    vec3 offset{};
    std::uint32_t number{};
    std::uint32_t samples{};
    static constexpr std::string_view name = "PastModel";
    static constexpr auto fields() {
        return std::tuple(field("bytes", &PastModel::bytes), field("offset", &PastModel::offset),
                          field("number", &PastModel::number), field("samples", &PastModel::samples));
    }
};

}  // namespace thaum::game
