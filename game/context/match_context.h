// game/context/match_context.h: the context of a match: everything that its systems read and write.
#pragma once
#include <memory>
#include <optional>

#include "core/jobs.h"
#include "ecs/schedule.h"
#include "ecs/world.h"
#include "game/components/match.h"
#include "game/components/power_up.h"
#include "game/context/event_journal.h"
#include "game/data/match_data.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "input/frame.h"
#include "physics/physics.h"

namespace thaum::game {

/// Periods of physics and gameplay systems, in ticks (architecture.md, "One tick").
inline constexpr Tick physics_period = 1;
inline constexpr Tick gameplay_period = 8;
inline constexpr double physics_dt = seconds(physics_period);
inline constexpr double gameplay_dt = seconds(gameplay_period);

/// Haptic setup of a match: the simulated device, and the limits and settings of each player.
struct HapticSetup {
    haptics::SimulatedDevice device;
    std::array<haptics::Servo, players> servos{};
    std::array<bool, players> on{};  ///< whether the player feels forces at all
    /// Share of a carried thing's weight that the player feels, 0 to 1.
    std::array<double, players> weight{};
    /// Share of the blows on a carried thing that the player feels, 0 to 1.
    std::array<double, players> blows{};
    /// Strengths of the brew's effects on the player's hand.
    std::array<haptics::FluidModes, players> brew{};
    /// Half the box of positions that the device reaches (m, device frame).
    std::array<vec3, players> reach{};
    /// Scale of hand motion relative to a device with the usual workspace.
    std::array<double, players> stride{};
    /// Displacement of the wand's tip per displacement of the hand (m/m).
    std::array<double, players> wand_per_hand{};
};

struct BrewWork;  // game/cauldron/cauldron.h

/// Force magnitudes of the last ticks (N), ring buffer indexed by tick.
using ForceTrace = std::array<float, 2048>;

struct MatchContext {
    ecs::World world;
    physics::Physics physics;
    const MatchData& data;
    HapticSetup touch;
    std::vector<input::DeviceSpec> devices;
    input::InputFrame frame;  ///< input frame of the current tick
    bool moved = true;  ///< false if the physics skipped its step in this tick because nothing could change
    /// Haptic models of this tick; parts that did not change are not written again.
    std::array<haptics::HapticModel, players> models{};
    /// Worker threads for large work, whose results are taken at a fixed tick.
    Jobs* jobs{};
    std::unique_ptr<BrewWork> brew{};  ///< computes the cauldron's brew; null until a player touches the brew
    /// Every event of the last seconds. It is not part of the state; restoring a state restarts it.
    EventJournal journal{};
    std::uint64_t bursts_seen{};  ///< number of the next event that may be a burst at the brew
    /// Force traces for display. They are not part of the state, so snapshots do not contain them.
    std::array<ForceTrace, players> felt{};
};

/// Declares all components of a match. Their order is part of the state's format.
void declare_components(ecs::World& world);

/// Returns the wizard of player 0 or 1.
ecs::Entity wizard_of(const ecs::World& world, std::uint32_t player);

/// Position of a wizard's eye (m, world).
vec3 eye_of(const WizardRules& rules, vec3 body_centre);

/// Distance along the ground from a wizard's feet to a position (m). std::nullopt if that is farther than
/// `most` or on another floor.
std::optional<double> way_on_floor(const WizardRules& rules, vec3 body_centre, vec3 place, double most);

/// Appends an event to the journal and to EventLog, and adds it to the match statistics. The calling system
/// must have declared that it writes EventLog.
void record(MatchContext& context, const Event& event);

/// Harm to a wizard.
struct Hurt {
    double points{};  ///< health to take (HP)
    std::uint32_t by = no_player;
    EventKind how{};
    vec3 place{};
};

/// Takes health and records the event, unless the wizard is shielded or dead. Writes Health and EventLog,
/// reads Wizard and Dead.
void hurt(MatchContext& context, ecs::Entity wizard, Tick tick, const Hurt& hurt);

}  // namespace thaum::game
