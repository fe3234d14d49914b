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

PastModel past(const haptics::HapticModel& model, std::uint32_t number, std::uint32_t samples) {
    haptics::HapticModel copy = model;
#if !defined(__clang__)  // which only looks at this code
    __builtin_clear_padding(&copy);
#endif
    PastModel kept{.number = number, .samples = samples};
    std::memcpy(kept.bytes.data(), &copy, sizeof copy);
    return kept;
}

input::KeptModel recalled(const PastModel& kept) {
    return {std::bit_cast<haptics::HapticModel>(kept.bytes), kept.number, kept.samples};
}

const PastModel& model_in(const ecs::World& world, const Arm& arm, std::uint32_t number) {
    return world.get<PastModel>(arm.models[number % arm.models.size()]);
}

/// What the hand of an arm is to everybody else.
void hold(const input::ArmState& state, Grip& grip) {
    auto& device = grip.device;
    grip.servo = state.servo;
    device.position = glm::clamp(input::position_of(state), vec3(-furthest), vec3(furthest));
    device.velocity = haptics::tip_velocity(state.servo);
    device.target = device.position;
    device.force = state.servo.safety.output;
}

void follow(Stage& stage, Arm& arm, bool skipped) {
    auto& world = stage.world;
    const auto& sample = stage.frame.devices[arm.device];
    const auto number = input::model_of(arm.state, sample);
    const auto used = recalled(model_in(world, arm, number));
    const bool known = number != 0 && used.number == number;
    input::take_sample(arm.state, stage.touch.servos[arm.player], sample, known ? &used : nullptr, skipped);
    hold(arm.state, world.get<Grip>(wizard_of(world, arm.player)));
}

const Arm* arm_of(const ecs::World& world, std::uint32_t player) {
    const Arm* found = nullptr;
    world.view<const Arm>().each([&](const Arm& arm) {
        if (arm.player == player) found = &arm;
    });
    return found;
}

}  // namespace

bool holds_arm(const Stage& stage, std::uint32_t player) {
    return std::any_of(stage.devices.begin(), stage.devices.end(), [&](const input::DeviceSpec& device) {
        return device.player == player && device.kind == input::DeviceKind::arm;
    });
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
            arm.state = old.state;
            begin_epoch(arm.state);
            arm.state.servo.last_pulse = 0;  // a new Grip counts anew
        }
        for (auto& model : arm.models) model = world.create(PastModel{});
        world.create(arm);
    }
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
        auto model = next_model(stage, wizard, world.get<Grip>(wizard), arm.panic_left > 0);
        model.on = model.on && live;
        model.rearm = arm.rearm_left > 0;
        const auto number = ++arm.state.number;
        world.get<PastModel>(arm.models[number % arm.models.size()]) = past(model, number, arm.state.samples);
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
             .start = arm->state.servo,
             .epoch = arm->state.epoch,
             .number = newest.number,
             .samples = newest.samples};
    return true;
}

}  // namespace thaum::game
