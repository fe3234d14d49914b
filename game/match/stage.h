// game/match/stage.h: what the systems of a match work on.
#pragma once
#include <memory>
#include <optional>

#include "core/jobs.h"
#include "ecs/schedule.h"
#include "ecs/world.h"
#include "game/components/match.h"
#include "game/components/power_up.h"
#include "game/match/data.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "input/frame.h"
#include "physics/physics.h"

namespace thaum::game {

/// Physics and gameplay run at these periods, in ticks (architecture.md, "One tick").
inline constexpr Tick physics_period = 1;
inline constexpr Tick gameplay_period = 8;
inline constexpr double physics_dt = seconds(physics_period);
inline constexpr double gameplay_dt = seconds(gameplay_period);

/// What hands hold in this match, prepared.
struct Touch {
    haptics::SimulatedDevice device;
    std::array<haptics::Servo, players> servos{};
    std::array<bool, players> on{};        ///< who wants to feel forces at all
    std::array<double, players> weight{};  ///< how much of a carried thing's weight he wants to feel, 0 to 1
    std::array<double, players> blows{};   ///< and of the blows that it takes
    std::array<haptics::FluidModes, players> brew{};  ///< and of a brew that he stirs
    std::array<vec3, players> reach{};                ///< m, half the box that the device reaches
    std::array<double, players>
        stride{};  ///< how much farther the device's hand goes than one in a usual workspace
    std::array<double, players> wand_per_hand{};  ///< m of the wand's tip for a metre of the hand
};

struct BrewWork;  // game/cauldron/cauldron.h

/// N, of each of the last ticks.
using ForceTrace = std::array<float, 2048>;

struct Stage {
    ecs::World world;
    physics::Physics physics;
    const MatchData& data;
    Touch touch;
    std::vector<input::DeviceSpec> devices;
    input::InputFrame frame;  ///< of the tick that runs
    bool moved = true;        ///< the physics made a step in this tick, or was not asked yet
    std::array<haptics::HapticModel, players>
        models{};                            ///< of this tick; what does not change is not written again
    Jobs* jobs{};                            ///< for large work, whose results are taken at a fixed tick
    std::unique_ptr<BrewWork> brew{};        ///< computes the cauldron's; null until it is touched
    std::array<ForceTrace, players> felt{};  ///< for the picture: no state, and starts anew with a restore
};

/// All components of a match, declared in their one order.
void declare_components(ecs::World& world);

/// The wizard of player 0 or 1.
ecs::Entity wizard_of(const ecs::World& world, std::uint32_t player);

/// Where a wizard's eye is, m.
vec3 eye_of(const WizardRules& rules, vec3 body_centre);

/// m, along the ground from a wizard's feet to a place; nothing where that is farther than `most` or on another floor.
std::optional<double> way_on_floor(const WizardRules& rules, vec3 body_centre, vec3 place, double most);

/// Adds to the Chronicle, its sums included; the caller's system must have declared that it writes it.
void record(ecs::World& world, const Event& event);

struct Hurt {
    double points{};  ///< HP
    std::uint32_t by = no_player;
    EventKind how{};
    vec3 place{};
};

/// Takes health and records it, unless the victim is shielded or dead. Writes Health and Chronicle, reads Wizard and Dead.
void hurt(ecs::World& world, ecs::Entity wizard, Tick tick, const Hurt& hurt);

}  // namespace thaum::game
