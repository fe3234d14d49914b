#include "game/match/hand/arm_system.h"

#include <algorithm>
#include <bit>

#include "game/context/arms.h"
#include "game/match/hand/hand_system.h"

namespace thaum::game::inline match {
namespace {

/// Number of ticks for which a press of the panic key is repeated in the haptic models sent to an arm's
/// thread, since the thread may skip models.
constexpr std::uint32_t press_kept = 40;
/// Limit of hand positions (m). No arm reaches farther, but a damaged log might contain more.
constexpr double furthest = 0.5;
/// An arm that has sent no samples for a while and then comes back must be held still for `still_ticks` ticks
/// within `still_within` um before it gives forces again.
constexpr std::uint32_t still_ticks = 300;
constexpr std::int32_t still_within = 3000;

PastModel past(const haptics::HapticModel& model, const input::ArmState& arm) {
    return {std::bit_cast<decltype(PastModel::bytes)>(model), arm.offset, arm.number, arm.samples};
}

input::RememberedModel recalled(const PastModel& kept) {
    return {std::bit_cast<haptics::HapticModel>(kept.bytes), kept.offset, kept.number, kept.samples};
}

const PastModel& model_in(const ecs::World& world, const Arm& arm, std::uint32_t number) {
    return world.get<PastModel>(arm.models[number % arm.models.size()]);
}

/// Copies position and servo state of the arm into HandState, where all other code reads them.
void hold(const input::ArmState& state, HandState& hand_state) {
    auto& device = hand_state.device;
    hand_state.servo = state.servo;
    device.position = glm::clamp(input::hand_of(state), vec3(-furthest), vec3(furthest));
    device.velocity = state.rests != 0 ? vec3(0) : haptics::tip_velocity(state.servo);
    device.target = device.position;
    device.force = state.servo.safety.output;
}

/// Lets the simulated hand continue from the position of the arm's hand. A kick that was meant for the arm is
/// over by then, so the simulated hand must not repeat it.
void take_over(const MatchContext& context, const Arm& arm, HandState& hand_state) {
    const vec3 reach = context.input.haptic_setup.device.reach;
    hand_state.servo = arm.state.servo;
    hand_state.servo.last_pulse = hand_state.kick.number;
    hand_state.home = glm::clamp(arm.state.hand, -reach, reach);
    hand_state.device = haptics::resting_at(hand_state.home);
}

bool moved(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(std::int64_t{a[i]} - b[i]) > still_within) return true;
    }
    return false;
}

/// Counts the ticks for which the arm has been held still; restarts the count when it moves.
void note_still(Arm& arm) {
    if (arm.state.without != 0) return;
    if (arm.still == 0 || moved(arm.state.position_um, arm.still_um)) {
        arm.still_um = arm.state.position_um;
        arm.still = 0;
    }
    if (++arm.still >= still_ticks) arm.away = 0;
}

/// Chooses who moves the hand: the arm, or the simulated hand while the arm sends no samples. An arm that has
/// come back continues from the simulated hand's position.
void note_presence(const MatchContext& context, Arm& arm, HandState& hand_state) {
    if (is_gone(arm)) {
        if (arm.away == 0) take_over(context, arm, hand_state);
        arm.away = arm.state.rests = 1;
        arm.still = 0;
        arm.state.rest = arm.state.hand = hand_state.device.position;
        return;
    }
    if (arm.away != 0) note_still(arm);
    hold(arm.state, hand_state);
}

void follow(MatchContext& context, Arm& arm, bool skipped) {
    auto& world = context.world;
    const auto& sample = context.input.frame.devices[arm.device];
    const auto number = input::model_of(arm.state, sample);
    const auto used = recalled(model_in(world, arm, number));
    const bool known = number != 0 && used.number == number;
    input::take_sample(arm.state, context.input.haptic_setup.servos[arm.player], sample,
                       known ? &used : nullptr, skipped);
    note_presence(context, arm, world.get<HandState>(wizard_of(world, arm.player)));
}

/// Continues an arm in a new scene, such as that of the next round. The arm's thread must then go on from the
/// state that the match chooses here, which is called a new epoch.
void go_on_with(const Arm& old, Arm& arm) {
    arm.state = old.state;
    begin_epoch(arm.state);
    arm.away = old.away;
    arm.still = old.still;
    arm.still_um = old.still_um;
}

}  // namespace

std::vector<Arm> arms_in(const ecs::World& world) {
    std::vector<Arm> arms;
    world.view<const Arm>().each([&](const Arm& arm) { arms.push_back(arm); });
    return arms;
}

void add_arms(MatchContext& context, const std::vector<Arm>& before) {
    auto& world = context.world;
    const auto& devices = context.input.devices;
    for (std::uint32_t d = 0; d < devices.size(); ++d) {
        const auto player = devices[d].player;
        const bool first = arm_of(world, player) == nullptr;
        if (devices[d].kind != input::DeviceKind::arm || player >= players || !first) continue;
        Arm arm{.player = player, .device = d};
        for (const auto& old : before) {
            if (old.device != d) continue;
            go_on_with(old, arm);
            arm.state.servo.last_pulse = 0;  // a new HandState numbers its pulses (kicks) from 1 again
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

void add_arm_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "arms",
                  .reads = world.mask<Wizard, PastModel>(),
                  .writes = world.mask<Arm, HandState>(),
                  .needs = world.mask<Arm>(),
                  .run = [&context](ecs::World& w, Tick) {
                      const auto& devices = context.input.frame.devices;
                      const bool skipped =
                          std::any_of(devices.begin(), devices.end(),
                                      [](const input::DeviceSample& sample) { return sample.skips != 0; });
                      w.view<Arm>().each([&](Arm& arm) { follow(context, arm, skipped); });
                  }});
}

void publish_models(MatchContext& context, const BrewResource& brew, bool live) {
    auto& world = context.world;
    world.view<Arm>().each([&](Arm& arm) {
        const auto wizard = wizard_of(world, arm.player);
        const bool clutch =
            (std::as_const(world).get<Controls>(wizard).held & bit(input::Button::clutch)) != 0;
        input::rest_hand(arm.state, clutch || arm.away != 0, context.input.haptic_setup.reach[arm.player]);
        // While the arm is gone, the simulated hand has already requested its own model in this tick.
        auto model = is_gone(arm) ? haptics::HapticModel{.panic = arm.panic_left > 0}
                                  : next_model(context, brew, wizard, world.get<HandState>(wizard),
                                               arm.panic_left > 0);
        model.on = model.on && live && arm.state.rests == 0;
        model.rearm = arm.rearm_left > 0;
        const auto number = ++arm.state.number;
        world.get<PastModel>(arm.models[number % arm.models.size()]) = past(model, arm.state);
        if (arm.panic_left > 0) --arm.panic_left;
        if (arm.rearm_left > 0) --arm.rearm_left;
    });
}

void recall_models(MatchContext& context) {
    auto& models = context.output.models.write();
    models = {};
    std::as_const(context.world).view<const Arm>().each([&](const Arm& arm) {
        if (arm.state.number == 0) return;
        models[arm.player] = recalled(model_in(context.world, arm, arm.state.number)).model;
    });
}

void tell_arms(ecs::World& world, bool panic) {
    world.view<Arm>().each([&](Arm& arm) {
        const bool rearm = std::as_const(world).get<HandState>(wizard_of(world, arm.player)).rearm != 0;
        if (panic || rearm) arm.panic_left = arm.rearm_left = 0;
        if (panic) arm.panic_left = press_kept;
        if (rearm && !panic) arm.rearm_left = press_kept;
    });
}

bool fill_order(const ecs::World& world, const HapticSetup& setup, std::uint32_t player,
                input::ArmOrder& order) {
    const auto* arm = arm_of(world, player);
    if (arm == nullptr || arm->state.number == 0) return false;
    const auto newest = recalled(model_in(world, *arm, arm->state.number));
    order = {.servo = setup.servos[player],
             .model = newest.model,
             .offset = newest.offset,
             .start = arm->state.servo,
             .epoch = arm->state.epoch,
             .number = newest.number,
             .samples = newest.samples};
    return true;
}

}  // namespace thaum::game::inline match
