#include "game/match/haptic_setup.h"

#include <cmath>

#include "game/components/hand_state.h"

namespace thaum::game::inline match {
namespace {

using input::HandFader;

/// Width of a typical device's workspace (m, left to right), for which the hand scales in data files are
/// given. For a narrower workspace the scales grow in proportion, so that the hand reaches equally far in the
/// world.
constexpr double usual_width = 0.16;

void set_workspace(const MatchData& data, std::uint32_t player, vec3 box, HapticSetup& setup) {
    setup.reach[player] = box / 2.0;
    setup.workspace_scale[player] = usual_width / box.x;
    setup.wand_per_hand[player] = data.haptic_rules.wand_per_hand * setup.workspace_scale[player];
}

/// Workspace of a real arm (m); zero if the device is no arm or gives no plausible size. Edges are limited to
/// 1 m: no real arm is wider, and a wider workspace would make the hand slow.
vec3 workspace_of(const input::DeviceSpec& device) {
    constexpr std::uint32_t min_um = 20'000, max_um = 1'000'000;
    vec3 box{};
    for (std::size_t i = 0; i < device.box_um.size(); ++i) {
        const auto edge = device.box_um[i];
        if (device.kind != input::DeviceKind::arm || edge < min_um) return vec3(0);
        box[static_cast<int>(i)] = std::min(edge, max_um) * 1e-6;
    }
    return box;
}

static_assert(haptics::fluid_modes.size() == input::fluid_faders);

/// Reduces the brew's effects on the hand, such as drag, to the shares that the player has chosen to feel.
void reduce_modes(const input::DeviceSpec& device, haptics::FluidModes& modes) {
    for (std::size_t i = 0; i < haptics::fluid_modes.size(); ++i)
        modes.*haptics::fluid_modes[i].strength *= 1 - device.fluid_reduction[i] / 100.0;
}

void set_force(const MatchData& data, std::uint32_t player, std::uint8_t percent, HapticSetup& setup) {
    const bool as_rules = percent == input::force_as_rules;
    const auto own = as_rules ? std::lround(100 * data.haptic_rules.share) : long{percent};
    setup.on[player] = own > 0;
    // This value depends only on the last move of the fader, so a restored match computes the same one.
    setup.force_percent[player] = static_cast<std::uint8_t>(own);
}

void apply(const MatchData& data, std::uint32_t player, const input::FaderChange& change,
           HapticSetup& setup) {
    const double share = change.percent / 100.0;
    switch (HandFader{change.fader}) {
        case HandFader::none: break;
        case HandFader::force: set_force(data, player, change.percent, setup); break;
        case HandFader::weight: setup.weight[player] = share; break;
        case HandFader::blows: setup.blows[player] = share; break;
        case HandFader::recoil: setup.recoil[player] = share; break;
        case HandFader::roughness: setup.roughness[player] = share; break;
        default: {
            const std::size_t source = change.fader - static_cast<std::size_t>(HandFader::fluid);
            const auto strength = haptics::fluid_modes[source].strength;
            setup.brew[player].*strength = share * (haptics::FluidModes{}.*strength);
        }
    }
}

/// The World's record of the faders (for strengths of forces) that players have moved. The first move creates
/// it.
MovedFaders& record_of(ecs::World& world) {
    ecs::Entity found;
    world.view<const MovedFaders>().each([&](ecs::Entity e, const MovedFaders&) { found = e; });
    if (world.alive(found)) return world.get<MovedFaders>(found);
    MovedFaders none;
    none.percent.fill(MovedFaders::at_rest);
    return world.get<MovedFaders>(world.create(none));
}

/// Ticks after a move of a fader (for the strength of forces) until every system has computed its forces
/// again.
constexpr std::uint8_t settling_ticks = gameplay_period + 1;

/// While a fader's move takes effect, gives the steady force of the hand a new number in every tick. The new
/// number makes the force fade from its old value to the new one.
void announce_switches(ecs::World& world) {
    world.view<MovedFaders>().each([&](MovedFaders& moved) {
        for (std::uint32_t p = 0; p < players; ++p) {
            if (moved.settling[p] == 0) continue;
            --moved.settling[p];
            ++world.get<HandState>(wizard_of(world, p)).steady_force.number;
        }
    });
}

}  // namespace

HapticSetup haptic_setup_of(const MatchData& data, const std::vector<input::DeviceSpec>& devices) {
    HapticSetup setup{.device = haptics::simulated_device(data.device, haptics::Hand{})};
    setup.on.fill(true);
    for (auto* shares : {&setup.weight, &setup.blows, &setup.recoil, &setup.roughness}) shares->fill(1);
    for (auto& servo : setup.servos) servo = haptics::servo_of(data.device, data.haptic_rules.share);
    for (std::uint32_t p = 0; p < players; ++p) set_workspace(data, p, data.device.workspace, setup);
    for (const auto& device : devices) {
        if (device.player >= players) continue;
        if (device.no_forces) setup.on[device.player] = false;
        if (device.force_percent != 0)
            setup.servos[device.player] = haptics::servo_of(data.device, device.force_percent / 100.0);
        if (const vec3 box = workspace_of(device); box.x > 0) set_workspace(data, device.player, box, setup);
        setup.weight[device.player] *= 1 - device.weight_reduction / 100.0;
        setup.blows[device.player] *= 1 - device.blow_reduction / 100.0;
        setup.recoil[device.player] *= 1 - device.recoil_reduction / 100.0;
        setup.roughness[device.player] *= 1 - device.roughness_reduction / 100.0;
        reduce_modes(device, setup.brew[device.player]);
    }
    return setup;
}

void move_faders(const MatchData& data, const std::vector<input::DeviceSpec>& devices,
                 const input::InputFrame& frame, ecs::World& world, HapticSetup& setup) {
    for (std::size_t i = 0; i < devices.size() && i < frame.devices.size(); ++i) {
        const auto& change = frame.devices[i].change;
        const auto player = devices[i].player;
        if (change.fader == 0 || !is_valid(change) || !devices[i].moves_faders || player >= players) continue;
        auto& moved = record_of(world);
        auto& value = moved.percent[player * input::hand_faders + change.fader - 1];
        if (value == change.percent) continue;  // the value is the same, so there is nothing to fade
        value = change.percent;
        moved.settling[player] = settling_ticks;
        apply(data, player, change, setup);
    }
    announce_switches(world);
}

const std::vector<std::string>& fader_names() {
    static const auto names = [] {
        std::vector<std::string> all{"force", "weight", "blows", "recoil", "roughness"};
        for (const auto& mode : haptics::fluid_modes) all.push_back("brew " + std::string(mode.name));
        return all;
    }();
    return names;
}

std::optional<MovedFaders> moved_faders_in(const ecs::World& world) {
    std::optional<MovedFaders> found;
    world.view<const MovedFaders>().each([&](const MovedFaders& moved) { found = moved; });
    return found;
}

void apply_moved_faders(const MatchData& data, const ecs::World& world, HapticSetup& setup) {
    const auto moved = moved_faders_in(world);
    if (!moved) return;
    for (std::size_t i = 0; i < moved->percent.size(); ++i) {
        if (moved->percent[i] == MovedFaders::at_rest) continue;
        const auto player = static_cast<std::uint32_t>(i / input::hand_faders);
        const auto fader = static_cast<std::uint8_t>(i % input::hand_faders + 1);
        apply(data, player, {fader, moved->percent[i]}, setup);
    }
}

}  // namespace thaum::game::inline match
