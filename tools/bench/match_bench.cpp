// Benchmarks a match: cost and allocations of a tick, and the cost of features that are idle.
#include <algorithm>
#include <functional>

#include "core/text.h"
#include "ecs/snapshot.h"
#include "game/components/cauldron.h"
#include "game/components/hand_state.h"
#include "game/data/wand_slots.h"
#include "game/stations/cauldron/cauldron.h"
#include "tests/scenes/carving_hands.h"
#include "tests/scenes/searching_hands.h"
#include "tests/scenes/stirring_hands.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using game::Simulation;

void tick_duel(const Options& options, Report& report) {
    auto scene = heaviest_duel();
    if (!there(scene, "tick")) return;
    auto& match = *scene->match;
    std::vector<double> samples(options.quick ? 20'000 : 120'000);
    for (auto& sample : samples) {
        const double start = now_us();
        match.tick(scene->next_frame());
        sample = now_us() - start;
    }
    std::uint32_t shots = 0;
    match.world().view<const game::WandBelt>().each([&](const game::WandBelt& belt) { shots += belt.fired; });
    Bytes bytes;
    match.save(bytes);
    report.rows.push_back(
        {.area = "tick",
         .name = "duel",
         .setting = {{"bots", std::int64_t{2}}, {"physics_period", std::int64_t{game::physics_period}}},
         .time_us = times(samples),
         .is_default = true,
         .metrics = {{"mean_us", mean(samples)},
                     {"ticks", static_cast<double>(samples.size())},
                     {"shots", static_cast<double>(shots)},
                     {"entities", static_cast<double>(match.world().size())},
                     {"storages", static_cast<double>(match.world().components().size())},
                     {"tables", static_cast<double>(match.world().tables().size())},
                     {"state_bytes", static_cast<double>(bytes.size())},
                     {"state_hash_us", median_of(200, [&] { do_not_optimise(match.state_hash()); })},
                     {"snapshot_us", median_of(200, [&] { match.save(bytes); })}},
         .hash = hex(match.state_hash())});
}

// ---- hands that hold --------------------------------------------------------------------------------------

/// Places each wizard in front of a pile of crates.
void place_before_crates(Simulation& match) {
    for (std::uint32_t player = 0; player < game::players; ++player) {
        const double side = player == 0 ? 1 : -1;
        const auto wizard = game::wizard_of(match.world(), player);
        const double height = match.world().get<game::Motion>(wizard).position.y;
        place(match, player, {10, height, 1.5 * side}, side > 0 ? pi : 0, -0.2);
    }
}

/// Moves both mice to and fro. Three quarters of the time the clutch is held, so that the mouse moves the
/// hand; otherwise it turns the view.
void shake_hands(Tick tick, input::InputFrame& frame) {
    for (std::size_t d = 0; d < game::players; ++d) {
        auto& sample = frame.devices[d];
        const bool hand = tick % 2000 < 1500;
        if (hand) sample.press(input::Button::clutch);
        sample.counts[input::hand::look_right] = tick % 400 < 200 ? 1 : -1;
    }
}

input::InputFrame pressing(input::Button button) {
    input::InputFrame frame;
    for (std::size_t d = 0; d < game::players; ++d) frame.devices[d].press(button);
    return frame;
}

/// Each of two hands holds and moves an object all the time.
void tick_duel_haptic(const Options& options, Report& report) {
    auto scene = idle_match({"lift.energy.per_s=0", "lift.energy.per_n_s=0"});
    if (!scene) return;
    auto& match = *scene->match;
    match.live().timing = false;
    place_before_crates(match);
    scene->run(500);
    for (auto& device : scene->frame.devices) device.wand = 4;
    scene->run(100);
    scene->frame = pressing(input::Button::fire);
    scene->run(100);
    std::vector<double> samples(options.quick ? 20'000 : 120'000);
    double felt = 0, created = 0;
    const auto allocations = allocation_count();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        auto frame = scene->frame;
        shake_hands(i, frame);
        samples[i] = us_of([&] { match.tick(frame); });
        felt +=
            static_cast<double>(match.felt(0)[match.match().played % std::tuple_size_v<game::ForceTrace>]);
    }
    const auto allocated = allocation_count() - allocations;
    int held = 0;
    match.world().view<const game::WandBelt, const game::HandState>().each(
        [&](ecs::Entity wizard, const game::WandBelt& belt, const game::HandState& hand_state) {
            held += game::wand_in_hand(match.data(), belt)->rules->held_at(match.world(), wizard) ? 1 : 0;
            created = std::max(created, hand_state.servo.energy.most_created);
        });
    report.rows.push_back({.area = "tick",
                           .name = "duel_haptic",
                           .setting = {{"hands", std::int64_t{2}}},
                           .time_us = times(samples),
                           .error = ErrorMeasure{"created_j", created},
                           .is_default = true,
                           .metrics = {{"mean_us", mean(samples)},
                                       {"things_held", static_cast<double>(held)},
                                       {"mean_force_n", felt / static_cast<double>(samples.size())},
                                       {"allocations", static_cast<double>(allocated)}},
                           .hash = hex(match.state_hash())});
}

// ---- hands that stir --------------------------------------------------------------------------------------

/// The wizard drops three ingredients, one after another.
void drop_three(SceneMatch& scene) {
    auto& world = scene.match->world_to_change();
    const auto wizard = game::wizard_of(world, 0);
    auto pressed = pressing(input::Button::stir);
    pressed.devices[0].press(input::Button::fire);
    for (std::uint32_t ingredient = 0; ingredient < 3; ++ingredient) {
        world.add(wizard, game::Pouch{.ingredient = ingredient});
        for (const auto& frame : {pressed, pressing(input::Button::stir)}) {
            scene.frame = frame;
            scene.run(40);
        }
    }
}

/// Largest energy that the passive sources of a hand, such as springs and walls, have created (J).
double most_created(const game::Simulation& match) {
    double created = 0;
    match.world().view<const game::HandState>().each([&](const game::HandState& hand_state) {
        created = std::max(created, hand_state.servo.energy.most_created);
    });
    return created;
}

double ingredient_count(const game::Cauldron& cauldron) {
    return static_cast<double>(std::count_if(cauldron.contents.begin(), cauldron.contents.end(),
                                             [](std::uint32_t w) { return w != game::no_ingredient; }));
}

/// Two ladles stir three substances all the time. The brew never boils over, and its fluid steps run on the
/// same core as the tick.
void tick_duel_cauldron(const Options& options, Report& report) {
    auto scene = idle_match({"cauldron.brewing.spoils_after_s=3600"});
    if (!scene) return;
    auto& match = *scene->match;
    match.live().timing = false;
    place_at_the_rim(match);
    scene->frame = pressing(input::Button::stir);
    scene->run(100);
    drop_three(*scene);
    for (Tick t = 0; t < 1000; ++t) match.tick(stirring(t));
    std::vector<double> samples(options.quick ? 4'000 : 32'000);
    double substeps = 0, iterations = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto frame = stirring(1000 + i);
        const double start = now_us();
        match.tick(frame);
        samples[i] = now_us() - start;
        substeps += match.brew()->report.substeps;
        iterations += match.brew()->report.pressure_iterations;
    }
    const auto& cauldron = match.world().single<game::Cauldron>();
    const auto& cells = match.brew()->brew.fluid.lattice.cells;
    report.rows.push_back(
        {.area = "tick",
         .name = "duel_cauldron",
         .setting = {{"ladles", std::int64_t{game::players}},
                     {"substances", std::int64_t{3}},
                     {"cells", text(cells[0], "x", cells[1], "x", cells[2])}},
         .time_us = times(samples),
         .error = ErrorMeasure{"created_j", most_created(match)},
         .is_default = true,
         .metrics = {{"mean_us", mean(samples)},
                     {"ingredients", ingredient_count(cauldron)},
                     {"substeps_per_step", substeps / static_cast<double>(samples.size())},
                     {"pressure_iterations_per_step", iterations / static_cast<double>(samples.size())},
                     {"brew_m_s", cauldron.speed},
                     {"mixing", cauldron.mixing}},
         .hash = hex(match.state_hash())});
}

/// Function that keeps a feature of the game busy; called before each tick.
using Stir = std::function<void(SceneMatch&, Tick)>;

struct Feature {
    const char* name;
    std::vector<std::string_view> systems;
    const char* idle_state;  ///< name of the idle state in the report, such as "absent" or "asleep"
    Stir stir;
    std::vector<std::string> overrides{};
    /// Number of ticks between half a second in which the feature is busy and the measurement of the idle
    /// feature; 0: the feature is never busy.
    Tick rest{};
};

struct Cost {
    double calls_per_tick{}, ns_per_tick{};
};

/// Time that reading the clock adds to the measured time of a system (ns).
double clock_ns() {
    return 1000 *
           median_of(2000,
                     [] {
                         for (int i = 0; i < 10; ++i) do_not_optimise(now_us());
                     }) /
           10;
}

Cost cost_of(const Feature& feature, bool idle, Tick count) {
    auto scene = idle_match(feature.overrides);
    if (!scene) return {};
    const auto stir = idle ? nullptr : feature.stir;
    if (!idle || feature.rest > 0) {
        for (Tick t = 0; t < 500; ++t) feature.stir(*scene, t), scene->run(1);
    }
    if (idle) {
        scene->frame = {};
        scene->run(feature.rest);
    }
    scene->match->live().reset_counts();
    for (Tick t = 0; t < count; ++t) {
        if (stir) stir(*scene, t);
        scene->run(1);
    }
    Cost cost;
    const double clock = clock_ns();
    for (const auto system : feature.systems) {
        cost.calls_per_tick += static_cast<double>(scene->counted(system).calls) / static_cast<double>(count);
        cost.ns_per_tick += static_cast<double>(scene->counted(system).time_ns) / static_cast<double>(count);
    }
    cost.ns_per_tick = std::max(0.0, cost.ns_per_tick - clock * cost.calls_per_tick);
    return cost;
}

void hold_fire(SceneMatch& scene, Tick) {
    for (auto& device : scene.frame.devices) device.buttons = 0;
    for (std::size_t d = 0; d < game::players; ++d) scene.frame.devices[d].press(input::Button::fire);
    auto& world = scene.match->world_to_change();
    world.view<game::WandBelt>().each([](game::WandBelt& belt) { belt.energy.fill(60); });
}

void kick_props(SceneMatch& scene, Tick tick) {
    if (tick % 200 != 0) return;
    auto& physics = scene.match->physics();
    scene.match->world().view<const game::Body, const game::Prop>().each(
        [&](ecs::Entity e, const game::Body& body, const game::Prop&) {
            physics.apply_central_impulse(e.index, vec3(0.5, 2, tick % 400 == 0 ? 0.7 : -0.7) * body.mass);
        });
}

void walk_about(SceneMatch& scene, Tick tick) {
    for (std::size_t d = 0; d < game::players; ++d) {
        scene.frame.devices[d].counts[input::hand::strafe] = tick % 1000 < 500 ? 127 : -127;
    }
}

void keep_dying(SceneMatch& scene, Tick tick) {
    if (tick % 4000 != 0) return;
    scene.match->world_to_change().view<game::Health>().each([](game::Health& h) { h.points = 0; });
}

void stir_brew(SceneMatch& scene, Tick tick) {
    if (tick == 0) place_at_the_rim(*scene.match);
    scene.frame = stirring(tick);
}

void carve_crystal(SceneMatch& scene, Tick tick) {
    if (tick == 0) place_at_the_crystal(*scene.match);
    scene.frame = carving(tick);
}

/// Two wizards search the flow in the orb with their probes all the time. Their focus, which searching uses
/// up, is refilled in each tick.
void search_orb(SceneMatch& scene, Tick tick) {
    if (tick == 0) place_at_the_orb(*scene.match);
    scene.match->world_to_change().view<game::Focus>().each([](game::Focus& focus) { focus.points = 100; });
    scene.frame = searching(tick);
}

void skip_features(const Options& options, Report& report) {
    const std::vector<std::string_view> fluid_systems{"brew", "brew's surface", "splashes"};
    const std::vector<std::string_view> crystal_systems{"carvers", "carving", "chisels", "chips"};
    // The brew is made thick here, because a less viscous one would need minutes to come to rest.
    const std::vector<std::string> thick_brew{"cauldron.brew.viscosity_m2_s=0.2",
                                              "cauldron.surface.damping_per_s=20"};
    const std::vector<Feature> features{
        {"missiles", {"bolts"}, "absent", hold_fire},
        {"resurrection", {"resurrection"}, "absent", keep_dying},
        {"bodies", {"physics", "places", "blows"}, "asleep", kick_props},
        {"wizards", {"walk", "physics", "places"}, "asleep", walk_about},
        {"fluid", fluid_systems, "absent", stir_brew},
        {"fluid", fluid_systems, "asleep", stir_brew, thick_brew, 20'000},
        {"crystal", crystal_systems, "untouched", carve_crystal},
        {"crystal", crystal_systems, "left", carve_crystal, {}, 100},
        {"orb", {"orb probes"}, "absent", search_orb},
    };
    const Tick count = options.quick ? 4000 : 16'000;
    for (const auto& feature : features) {
        const Cost active = cost_of(feature, false, count);
        const Cost idle = cost_of(feature, true, count);
        for (const auto& [state, cost] : {std::pair{feature.idle_state, idle}, {"active", active}}) {
            report.rows.push_back({.area = "skip",
                                   .name = feature.name,
                                   .setting = {{"state", std::string(state)}},
                                   .metrics = {{"calls_per_tick", cost.calls_per_tick},
                                               {"ns_per_tick", cost.ns_per_tick},
                                               {"ratio_to_active", cost.ns_per_tick / active.ns_per_tick}}});
        }
    }
}

}  // namespace

void tick(const Options& options, Report& report) {
    tick_duel(options, report);
    tick_allocations(options, report);
    tick_bots(options, report);
    tick_duel_haptic(options, report);
    tick_duel_cauldron(options, report);
    tick_duel_felt(options, report);
}

void skip(const Options& options, Report& report) {
    skip_features(options, report);
    skip_senses(options, report);
    skip_scan(options, report);
}

}  // namespace thaum::bench
