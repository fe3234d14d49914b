#include "game/match/simulation.h"

#include "ecs/snapshot.h"
#include "game/casting/casting.h"
#include "game/casting/free_casting.h"
#include "game/context/effects.h"
#include "game/context/stations.h"
#include "game/match/belt.h"
#include "game/match/bodies.h"
#include "game/match/carry_over.h"
#include "game/match/great_work.h"
#include "game/match/hand/arm_system.h"
#include "game/match/hand/bare_probe.h"
#include "game/match/hand/hand_system.h"
#include "game/match/haptic_setup.h"
#include "game/match/life.h"
#include "game/match/own_gestures.h"
#include "game/match/player/controls.h"
#include "game/match/player/walk.h"
#include "game/match/power_ups.h"
#include "game/match/round.h"
#include "game/stations/cauldron/brewing.h"
#include "game/stations/cauldron/ladle.h"
#include "game/stations/cauldron/potions.h"
#include "game/stations/cauldron/splash.h"
#include "game/stations/crystal/chips.h"
#include "game/stations/crystal/chisel.h"
#include "game/stations/orb/orb.h"
#include "game/stations/orb/scrying.h"

namespace thaum::game::inline match {
namespace {

void spawn_match(ecs::World& world, std::uint64_t seed) {
    world.create(Match{}, Dice{.spread = random_stream(seed, 1)}, EventLog{});
}

/// Creates the parts of the state that depend on the seed.
void draw_by_seed(MatchContext& context, std::uint64_t seed) {
    draw_orders(context, seed);
    draw_crystals(context, seed);
    spawn_orb(context, seed);
}

void add_hand_systems(MatchContext& context, BrewResource& brew, CrystalResource& crystals,
                      ecs::Schedule& schedule) {
    if (context.data.cauldron) add_stir_system(context, brew, schedule);
    if (context.data.crystal) add_carving_systems(context, crystals, schedule);
    add_scrying_system(context, schedule);
    add_hand_system(context, brew, schedule);
    if (context.data.crystal) add_chisel_system(context, schedule);
    add_orb_probe_system(context, schedule);
    if (!context.data.cauldron) return;
    add_station_gaze_system(context, schedule);
    add_ladle_system(context, schedule);
    add_put_away_system(context, schedule);
}

void add_cauldron_systems(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule) {
    add_splash_system(context, brew, schedule);
    add_brewing_systems(context, brew, schedule);
    add_effect_systems(context, schedule);
    add_drawn_orders_system(context, schedule);
    add_brew_systems(context, brew, schedule);
}

/// Adds the systems that move bodies, and those of wands and strokes.
void add_fighting_systems(MatchContext& context, CrystalResource& crystals, ecs::Schedule& schedule) {
    add_wand_forces(context, schedule);
    add_body_systems(context, schedule);
    add_missile_systems(context, schedule);
    if (context.data.crystal) add_chip_system(context, crystals, schedule);
    add_belt_system(context, schedule);
    add_casting_systems(context, schedule);
    add_free_casting_systems(context, schedule);
}

}  // namespace

Simulation::Simulation(std::shared_ptr<const MatchData> data, MatchSetup setup)
    : data_(std::move(data)),
      setup_(std::move(setup)),
      input_{.haptic_setup = haptic_setup_of(*data_, setup_.devices),
             .devices = setup_.devices,
             .gestures = setup_.gestures,
             .strokes_unread = {},
             .frame = {}},
      context_(*data_, input_),
      brew_(context_.world, jobs_),
      crystals_(context_.world),
      jobs_(setup_.workers) {
    auto& context = context_;
    declare_components(context.world);
    context.world.reserve_entities(1024);
    add_body_hooks(context);
    spawn_match(context.world, setup_.seed);
    open_round(context, brew_.write(), crystals_.write());
    draw_by_seed(context, setup_.seed);

    add_arm_system(context, always_);
    add_controls_system(context, always_);
    add_interval_system(context, always_);
    add_pause_system(context, always_);

    add_hand_systems(context, brew_, crystals_, live_);
    add_walk_system(context, live_);
    add_probe_system(context, live_);
    add_fighting_systems(context, crystals_, live_);
    if (data_->cauldron)
        add_cauldron_systems(context, brew_, live_);
    else
        add_effect_systems(context, live_);
    add_power_up_system(context, live_);
    add_life_systems(context, live_);
    add_great_work_system(context, live_);
    add_round_system(context, live_);
    add_controls_used_system(context, live_);
    keyframe();
}

Simulation::~Simulation() = default;

void Simulation::tick(const input::InputFrame& frame) {
    if (now_ % keyframe_interval == 0 && now_ != 0) keyframe();
    if (now_ % hash_interval == 0) force_hash_ = 0;
    input_.frame = frame;
    auto& world = context_.world;
    move_faders(*data_, setup_.devices, frame, world, input_.haptic_setup);
    always_.run(world, now_);
    if (next_round_is_due(context_)) begin_next_round(context_, brew_.write(), crystals_.write());
    const auto& match = std::as_const(world).single<Match>();
    const bool live = match.paused == 0 && match.phase == Phase::playing;
    if (live) {
        live_.run(world, match.played);
        force_hash_ = chained_force_hash(world, force_hash_);
        ++world.single<Match>().played;
    }
    publish_models(context_, brew_, live);
    for (const auto& device : frame.devices) world.single<Match>().skipped += device.skips;
    ++now_;
    // At a keyframe the state may be saved. It must then include impulses that systems gave to bodies after
    // the physics step, such as those on a thing that flies back to its wizard by a spell.
    if (now_ % keyframe_interval == 0) copy_places(context_);
}

void Simulation::keyframe() {
    copy_places(context_);
    context_.physics.write().rebuild();
}

Expected<void> Simulation::restore(std::span<const std::byte> snapshot, Tick at) {
    THAUM_ASSERT(at % keyframe_interval == 0, text("restored at tick ", at, ", which is no keyframe"));
    if (auto restored = ecs::restore(context_.world, snapshot); !restored) return restored;
    input_.haptic_setup = haptic_setup_of(*data_, setup_.devices);
    apply_moved_faders(*data_, context_.world, input_.haptic_setup);
    auto& journal = context_.output.journal.write();
    journal.restart(std::as_const(context_.world).single<EventLog>());
    brew_.write().bursts_seen = journal.count();
    context_.output.forces.write() = {};
    context_.output.strokes.write() = {};
    recall_models(context_);
    rebuild_physics(context_);
    rebuild_brew(context_, brew_.write());
    rebuild_crystals(context_, crystals_.write());
    now_ = at;
    return {};
}

const HapticSetup& Simulation::haptic_setup() const { return input_.haptic_setup; }
const BrewWork* Simulation::brew() const { return brew_.read().work.get(); }
const CrystalBodies& Simulation::crystals() const { return crystals_.read(); }
CrystalBodies& Simulation::crystals_to_change() { return crystals_.write(); }
const ForceTrace& Simulation::felt(std::uint32_t player) const {
    return context_.output.forces.read()[player];
}

std::unique_ptr<Simulation> Simulation::continued_with(std::shared_ptr<const MatchData> data) const {
    auto setup = setup_;
    // Players' own gestures are recombined with the gestures of the new data. If an own gesture no longer
    // fits, the old set is kept.
    (void)use_profile(*data, setup_.profile, setup);
    return continued_with(std::move(data), std::move(setup));
}

std::unique_ptr<Simulation> Simulation::continued_with(std::shared_ptr<const MatchData> data,
                                                       MatchSetup setup) const {
    auto next = std::make_unique<Simulation>(std::move(data), std::move(setup));
    carry_over(context_, next->context_);
    apply_moved_faders(*next->data_, next->context_.world, next->input_.haptic_setup);
    auto& solver = next->brew_.write();
    solver.bursts_seen = brew_.read().bursts_seen;
    rebuild_brew(next->context_, solver);
    rebuild_crystals(next->context_, next->crystals_.write());
    next->now_ = now_;
    next->force_hash_ = force_hash_;
    next->input_.strokes_unread = input_.strokes_unread;
    return next;
}

void Simulation::save(Bytes& out) const { ecs::save(context_.world, out); }
std::uint64_t Simulation::state_hash() const { return ecs::state_hash(context_.world); }
const ecs::World& Simulation::world() const { return context_.world; }
ecs::World& Simulation::world_to_change() { return context_.world; }
MatchContext& Simulation::context_to_change() { return context_; }
void Simulation::leave_strokes_unread(std::uint32_t player, bool unread) {
    input_.strokes_unread.at(player) = unread;
}
const EventJournal& Simulation::events() const { return context_.output.journal.read(); }
physics::Physics& Simulation::physics() { return context_.physics.write(); }
const physics::Physics& Simulation::physics() const { return context_.physics.read(); }

}  // namespace thaum::game::inline match
