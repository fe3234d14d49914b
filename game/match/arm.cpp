#include "game/match/arm.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "game/match/touch.h"

namespace thaum::game {
namespace {

/// Ticks for which a key's press stays in the models.
constexpr std::uint32_t press_kept = 40;
/// m: no arm reaches further; a damaged log might.
constexpr double furthest = 0.5;
/// Ticks without a sample after which the arm is gone, and the simulated hand plays on.
constexpr std::uint32_t gone_after = 250;
/// Ticks for which an arm that is back must be held still, within so many um, before it is felt.
constexpr std::uint32_t still_ticks = 300;
constexpr std::int32_t still_within = 3000;

PastModel past(const haptics::HapticModel& model, const input::ArmState& arm) {
    haptics::HapticModel copy = model;
#if !defined(__clang__)  // which only looks at this code
    __builtin_clear_padding(&copy);
#endif
    PastModel kept{.offset = arm.offset, .number = arm.number, .samples = arm.samples};
    std::memcpy(kept.bytes.data(), &copy, sizeof copy);
    return kept;
}

input::KeptModel recalled(const PastModel& kept) {
    return {std::bit_cast<haptics::HapticModel>(kept.bytes), kept.offset, kept.number, kept.samples};
}

const PastModel& model_in(const ecs::World& world, const Arm& arm, std::uint32_t number) {
    return world.get<PastModel>(arm.models[number % arm.models.size()]);
}

/// What the hand of an arm is to everybody else.
void hold(const input::ArmState& state, Grip& grip) {
    auto& device = grip.device;
    grip.servo = state.servo;
    device.position = glm::clamp(input::hand_of(state), vec3(-furthest), vec3(furthest));
    device.velocity = state.rests != 0 ? vec3(0) : haptics::tip_velocity(state.servo);
    device.target = device.position;
    device.force = state.servo.safety.output;
}

bool is_gone(const Arm& arm) { return arm.state.without >= gone_after; }

/// The simulated hand goes on where the real one was.
void take_over(const Stage& stage, const Arm& arm, Grip& grip) {
    const vec3 reach = stage.touch.device.reach;
    grip.servo = arm.state.servo;
    grip.home = glm::clamp(arm.state.hand, -reach, reach);
    grip.device = haptics::resting_at(grip.home);
}

bool moved(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(std::int64_t{a[i]} - b[i]) > still_within) return true;
    }
    return false;
}

/// One more tick in which it is held still, or the first.
void note_still(Arm& arm) {
    if (arm.state.without != 0) return;
    if (arm.still == 0 || moved(arm.state.position_um, arm.still_um)) {
        arm.still_um = arm.state.position_um;
        arm.still = 0;
    }
    if (++arm.still >= still_ticks) arm.away = 0;
}

/// Whose hand plays: the arm's, or the simulated one while it is gone. The arm comes back to where that is by then.
void note_presence(const Stage& stage, Arm& arm, Grip& grip) {
    if (is_gone(arm)) {
        if (arm.away == 0) take_over(stage, arm, grip);
        arm.away = arm.state.rests = 1;
        arm.still = 0;
        arm.state.rest = arm.state.hand = grip.device.position;
        return;
    }
    if (arm.away != 0) note_still(arm);
    hold(arm.state, grip);
}

void follow(Stage& stage, Arm& arm, bool skipped) {
    auto& world = stage.world;
    const auto& sample = stage.frame.devices[arm.device];
    const auto number = input::model_of(arm.state, sample);
    const auto used = recalled(model_in(world, arm, number));
    const bool known = number != 0 && used.number == number;
    input::take_sample(arm.state, stage.touch.servos[arm.player], sample, known ? &used : nullptr, skipped);
    note_presence(stage, arm, world.get<Grip>(wizard_of(world, arm.player)));
}

/// In another scene, from which on the arm's thread begins anew.
void go_on_with(const Arm& old, Arm& arm) {
    arm.state = old.state;
    begin_epoch(arm.state);
    arm.away = old.away;
    arm.still = old.still;
    arm.still_um = old.still_um;
}

const Arm* arm_of(const ecs::World& world, std::uint32_t player) {
    const Arm* found = nullptr;
    world.view<const Arm>().each([&](const Arm& arm) {
        if (arm.player == player) found = &arm;
    });
    return found;
}

}  // namespace

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

std::vector<Arm> arms_in(const ecs::World& world) {
    std::vector<Arm> arms;
    world.view<const Arm>().each([&](const Arm& arm) { arms.push_back(arm); });
    return arms;
}

void add_arms(Stage& stage, const std::vector<Arm>& before) {
    auto& world = stage.world;
    for (std::uint32_t d = 0; d < stage.devices.size(); ++d) {
        const auto player = stage.devices[d].player;
        const bool first = arm_of(world, player) == nullptr;
        if (stage.devices[d].kind != input::DeviceKind::arm || player >= players || !first) continue;
        Arm arm{.player = player, .device = d};
        for (const auto& old : before) {
            if (old.device != d) continue;
            go_on_with(old, arm);
            arm.state.servo.last_pulse = 0;  // a new Grip counts anew
        }
        for (auto& model : arm.models) model = world.create(PastModel{});
        world.create(arm);
    }
}

void carry_arms(const std::vector<Arm>& before, ecs::World& world) {
    world.view<Arm>().each([&](Arm& arm) {
        for (const auto& old : before) {
            if (old.device == arm.device) go_on_with(old, arm);
        }
    });
}

void add_arm_system(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "arms",
                  .reads = world.mask<Wizard, PastModel>(),
                  .writes = world.mask<Arm, Grip>(),
                  .needs = world.mask<Arm>(),
                  .run = [&stage](ecs::World& w, Tick) {
                      const auto& devices = stage.frame.devices;
                      const bool skipped =
                          std::any_of(devices.begin(), devices.end(),
                                      [](const input::DeviceSample& sample) { return sample.skips != 0; });
                      w.view<Arm>().each([&](Arm& arm) { follow(stage, arm, skipped); });
                  }});
}

void publish_models(Stage& stage, bool live) {
    auto& world = stage.world;
    world.view<Arm>().each([&](Arm& arm) {
        const auto wizard = wizard_of(world, arm.player);
        const bool clutch =
            (std::as_const(world).get<Controls>(wizard).held & bit(input::Button::clutch)) != 0;
        input::rest_hand(arm.state, clutch || arm.away != 0, stage.touch.reach[arm.player]);
        // Gone: the simulated hand has asked for its own already.
        auto model = is_gone(arm) ? haptics::HapticModel{.panic = arm.panic_left > 0}
                                  : next_model(stage, wizard, world.get<Grip>(wizard), arm.panic_left > 0);
        model.on = model.on && live && arm.state.rests == 0;
        model.rearm = arm.rearm_left > 0;
        const auto number = ++arm.state.number;
        world.get<PastModel>(arm.models[number % arm.models.size()]) = past(model, arm.state);
        if (arm.panic_left > 0) --arm.panic_left;
        if (arm.rearm_left > 0) --arm.rearm_left;
    });
}

void tell_arms(ecs::World& world, bool panic) {
    world.view<Arm>().each([&](Arm& arm) {
        const bool rearm = std::as_const(world).get<Grip>(wizard_of(world, arm.player)).rearm != 0;
        if (panic || rearm) arm.panic_left = arm.rearm_left = 0;
        if (panic) arm.panic_left = press_kept;
        if (rearm && !panic) arm.rearm_left = press_kept;
    });
}

bool fill_order(const Simulation& match, std::uint32_t player, input::ArmOrder& order) {
    const auto* arm = arm_of(match.world(), player);
    if (arm == nullptr || arm->state.number == 0) return false;
    const auto newest = recalled(model_in(match.world(), *arm, arm->state.number));
    order = {.servo = match.touch().servos[player],
             .model = newest.model,
             .offset = newest.offset,
             .start = arm->state.servo,
             .epoch = arm->state.epoch,
             .number = newest.number,
             .samples = newest.samples};
    return true;
}

}  // namespace thaum::game
