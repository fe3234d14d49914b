// game/context/match_context.h: the context of a match, which its systems share, split by use: what they only
// read (data and input), the state (World and physics), and the outputs.
//
// Systems declare access to components of the World and to resources: the physics and each output. Every
// access to one of these is checked while a system runs (ecs/schedule.h).
#pragma once
#include <memory>
#include <optional>

#include "ecs/schedule.h"
#include "game/components/match.h"
#include "game/context/resources.h"
#include "game/data/match_data.h"
#include "game/data/periods.h"
#include "haptics/simulated.h"
#include "input/frame.h"

namespace thaum::game::inline context {

/// Haptic setup of a match: the simulated device, and the limits and settings of each player. What changes in
/// each tick, the state of simulated devices and of their force computation (servo), is in the component
/// HandState.
struct HapticSetup {
    haptics::SimulatedDevice device;
    std::array<haptics::Servo, players> servos{};
    std::array<bool, players> on{};  ///< true: the player feels forces
    /// Largest force that a player has chosen during the match (% of the device's peak); 0: the player has
    /// not chosen one, so the limit in `servos` applies.
    std::array<std::uint8_t, players> force_percent{};
    /// Share of a carried thing's weight that the player feels, 0 to 1.
    std::array<double, players> weight{};
    /// Share of the blows that hit a carried thing and that the player feels, 0 to 1.
    std::array<double, players> blows{};
    /// Share of the wands' recoil that the player feels, 0 to 1.
    std::array<double, players> recoil{};
    /// Share of the friction of touched things that the player feels, 0 to 1.
    std::array<double, players> roughness{};
    /// Strengths of the effects that the brew, the liquid in the cauldron, has on the player's hand.
    std::array<haptics::FluidModes, players> brew{};
    /// Half the size of the box of positions that the device can reach (m, device frame).
    std::array<vec3, players> reach{};
    /// Scale of hand motion, relative to a device whose workspace is 0.16 m wide (m/m). A narrower device
    /// gets a larger scale, so that every hand reaches equally far in the world.
    std::array<double, players> workspace_scale{};
    /// Displacement of the wand's tip per displacement of the hand (m/m).
    std::array<double, players> wand_per_hand{};
};

/// Largest force that a player's hand may get, by the device and the player's own limit (N).
double force_cap(const HapticSetup& setup, std::uint32_t player);

/// The players' devices and their input. The simulation owns this and fills in the input frame of each tick.
struct MatchInput {
    HapticSetup haptic_setup;
    std::vector<input::DeviceSpec> devices;  ///< the players' devices, in the order of the samples in `frame`
    /// Gestures of players who recorded their own; null: those of the match's data.
    std::array<std::shared_ptr<const GestureSet>, players> gestures{};
    /// Players whose strokes are not recognised at present, because the gesture wall, the practice range's
    /// display of gestures, records them. Never set in a logged match.
    std::array<bool, players> strokes_unread{};
    input::InputFrame frame;  ///< input frame of the current tick
};

/// Outputs of a match besides its state: haptic models, events, curves of the force on the hands, ended
/// strokes. They are neither saved nor hashed.
struct MatchOutput {
    explicit MatchOutput(ecs::World& world) : models(world), journal(world), forces(world), strokes(world) {}

    ecs::Resource<resource::Models> models;
    ecs::Resource<resource::Journal> journal;
    ecs::Resource<resource::Forces> forces;
    ecs::Resource<resource::Strokes> strokes;
};

struct MatchContext {
    /// `match_data` and `match_input` must outlive the context.
    MatchContext(const MatchData& match_data, const MatchInput& match_input);

    const MatchData& data;
    const MatchInput& input;
    ecs::World world;
    ecs::Resource<resource::Physics> physics;
    MatchOutput output;
};

/// Declares all components of a match. Their order is part of the state's format.
void declare_components(ecs::World& world);

/// Returns the wizard of player 0 or 1.
ecs::Entity wizard_of(const ecs::World& world, std::uint32_t player);

/// Gestures of a player: the player's own, or those of the match's data; null if the match has none.
const GestureSet* gestures_of(const MatchContext& context, std::uint32_t player);

/// Position of a wizard's eye (m, world). `body_centre`: middle of the wizard's body.
vec3 eye_of(const WizardRules& rules, vec3 body_centre);

/// Distance along the ground from a wizard's feet to a position (m). std::nullopt if that is farther than
/// `most` or on another floor.
std::optional<double> distance_on_floor(const WizardRules& rules, vec3 body_centre, vec3 place, double most);

/// Appends an event to the journal (all events of the last seconds) and to EventLog (the last 64, part of the
/// state). Adds it to the match statistics. The calling system must have declared that it writes EventLog and
/// resource::Journal.
void record(MatchContext& context, const Event& event);

/// Harm to be done to a wizard.
struct Hurt {
    double points{};  ///< health to be taken (HP)
    std::uint32_t by = no_player;
    EventKind how{};
    vec3 place{};
    std::uint32_t detail{};  ///< further number in the recorded event (Event::detail), whose meaning depends
                             ///< on its kind
    bool pierces{};          ///< true: the Shield spell absorbs none of the harm
};

/// Takes health and records the event. Does nothing to a dead wizard, nor to one who is protected after a
/// return to life; effects change how much, and the Shield spell absorbs a part. Writes Health, EventLog and
/// resource::Journal, reads Wizard, Effects and Dead.
void hurt(MatchContext& context, ecs::Entity wizard, Tick tick, const Hurt& harm);

}  // namespace thaum::game::inline context
