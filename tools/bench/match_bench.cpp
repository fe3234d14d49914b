// What a tick of the duel costs, whether it allocates, how fast a log is verified, and what idle features cost.
#include <chrono>
#include <cstdio>
#include <functional>

#include "core/text.h"
#include "ecs/snapshot.h"
#include "game/bots/duel.h"
#include "game/components/grip.h"
#include "game/match/playback.h"
#include "game/wands/belt.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using game::Simulation;

double now_us() {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// A benchmark without its scene says so and gives no row.
template <class T>
bool there(const Expected<T>& value, std::string_view what) {
    if (!value)
        std::fprintf(stderr, "bench: %s: %s\n", std::string(what).c_str(), value.error().message.c_str());
    return value.has_value();
}

std::shared_ptr<const game::MatchData> duel_data(std::vector<std::string> overrides = {}) {
    // A match that cannot end while it is measured.
    overrides.insert(overrides.end(), {"quick.kills=1000", "quick.seconds=36000"});
    auto data = game::load_match_data(game::find_assets(), {.overrides = std::move(overrides)});
    return there(data, "duel") ? std::make_shared<const game::MatchData>(std::move(*data)) : nullptr;
}

/// The bots that think most.
constexpr int heaviest = game::bot_levels;

Expected<game::BotDuel> duel() {
    auto data = duel_data();
    if (!data) return fail("no data");
    return game::make_bot_duel(game::find_assets(), data, {heaviest, heaviest}, 1);
}

double mean(const std::vector<double>& samples) {
    double sum = 0;
    for (const double s : samples) sum += s;
    return sum / static_cast<double>(samples.size());
}

double median_of(std::size_t count, const std::function<void()>& run) {
    std::vector<double> samples;
    for (std::size_t i = 0; i < count; ++i) {
        const double start = now_us();
        run();
        samples.push_back(now_us() - start);
    }
    return median(samples);
}

void tick_duel(const Options& options, Report& report) {
    auto scene = duel();
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
         .setting = {{"bots", std::int64_t{2}},
                     {"level", std::int64_t{heaviest}},
                     {"physics_period", std::int64_t{game::physics_period}}},
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

void tick_alloc(const Options& options, Report& report) {
    auto scene = duel();
    if (!there(scene, "tick")) return;
    constexpr Tick warm_up = 10'000;
    const Tick counted = options.quick ? 20'000 : 60'000;
    // The first death makes the tables that the dead live in; once for each match.
    scene->match->world_to_change().view<game::Health>().each([](game::Health& h) { h.points = 0; });
    scene->run(warm_up);
    const auto before = allocation_count();
    scene->run(counted);
    const auto after = allocation_count();
    std::uint32_t shots = 0;
    scene->match->world().view<const game::WandBelt>().each(
        [&](const game::WandBelt& b) { shots += b.fired; });
    report.rows.push_back({.area = "tick",
                           .name = "alloc",
                           .setting = {{"after_s", std::int64_t{10}}},
                           .metrics = {{"allocations_per_tick",
                                        static_cast<double>(after - before) / static_cast<double>(counted)},
                                       {"allocations", static_cast<double>(after - before)},
                                       {"counted", allocations_are_counted() ? 1.0 : 0.0},
                                       {"ticks", static_cast<double>(counted)},
                                       {"shots", static_cast<double>(shots)}}});
}

struct Verified {
    double took_us{};  ///< opening, replaying and comparing
    double real_time_factor{};
    double ratio_to_tick{};  ///< to what the live ticks, bots included, would allow
    std::size_t mismatches{};
    double log_bytes_per_minute{};
    std::string hash;
};

/// Records a duel, then verifies its log.
Expected<Verified> record_and_verify(Tick length) {
    auto scene = duel();
    if (!scene) return tl::unexpected(scene.error());
    auto& match = *scene->match;
    const auto file = std::filesystem::temp_directory_path() /
                      text("thaum-bench-", static_cast<long>(now_us()), ".thaumlog");
    auto log = input::LogWriter::create(
        file, game::log_header(match.data(), match.setup(), {text("bot ", heaviest), text("bot ", heaviest)}),
        input::WhenBehind::wait);
    if (!log) return tl::unexpected(log.error());
    double ticking_us = 0;
    for (Tick t = 0; t < length; ++t) {
        const double start = now_us();
        const auto frame = scene->next_frame();
        match.tick(frame);
        ticking_us += now_us() - start;
        log->append(frame);
        if (match.now() % hash_interval == 0) log->append_hash(match.now(), match.state_hash(), 0);
    }
    if (auto closed = log->close("bench"); !closed) return tl::unexpected(closed.error());
    Verified result;
    std::error_code ignored;
    result.log_bytes_per_minute =
        static_cast<double>(std::filesystem::file_size(file, ignored)) / (seconds(length) / 60.0);
    const double start = now_us();
    auto playback = game::Playback::open(file, game::find_assets());
    while (playback && playback->step()) result.mismatches += playback->mismatch() ? 1U : 0U;
    result.took_us = now_us() - start;
    std::filesystem::remove(file, ignored);
    if (!playback) return tl::unexpected(playback.error());
    result.real_time_factor = seconds(length) * 1e6 / result.took_us;
    result.ratio_to_tick = ticking_us / result.took_us;
    result.hash = hex(playback->match().state_hash());
    return result;
}

void replay_verify(const Options& options, Report& report) {
    std::vector<double> took, factors, ratios;
    Verified last;
    for (int round = 0; round < 5;
         ++round) {  // recording and verifying by turns, so that both meet the same machine
        auto verified = record_and_verify(options.quick ? 10'000 : 40'000);
        if (!there(verified, "replay")) return;
        last = std::move(*verified);
        took.push_back(last.took_us);
        factors.push_back(last.real_time_factor);
        ratios.push_back(last.ratio_to_tick);
    }
    report.rows.push_back({.area = "replay",
                           .name = "verify",
                           .setting = {{"scene", std::string("duel")}},
                           .time_us = times(took),
                           .is_default = true,
                           .metrics = {{"real_time_factor", median(factors)},
                                       {"ratio_to_tick", median(ratios)},
                                       {"mismatches", static_cast<double>(last.mismatches)},
                                       {"log_bytes_per_minute", last.log_bytes_per_minute}},
                           .hash = last.hash});
}

struct IdleMatch {
    std::unique_ptr<Simulation> match;
    input::InputFrame frame;  ///< the same in every tick

    void run(Tick count) {
        for (Tick t = 0; t < count; ++t) match->tick(frame);
    }
    ecs::SystemCount counted(std::string_view system) const {
        const auto& schedule = match->live();
        for (std::size_t i = 0; i < schedule.size(); ++i) {
            if (schedule.system(i).name == system) return schedule.counted(i);
        }
        return {};
    }
};

std::optional<IdleMatch> idle_match(std::vector<std::string> overrides = {}) {
    auto data = duel_data(std::move(overrides));
    if (!data) return std::nullopt;
    const input::DeviceSpec nobody{.player = 0, .kind = input::DeviceKind::script, .name = "nobody"};
    auto other = nobody;
    other.player = 1;
    IdleMatch scene{std::make_unique<Simulation>(data, game::MatchSetup{1, {nobody, other}}), {}};
    scene.match->live().timing = true;
    scene.run(6000);  // all has come to rest
    return scene;
}

// ---- hands that hold -----------------------------------------------------------------------------------------------

/// Each wizard before a pile of crates of his own.
void place_before_crates(Simulation& match) {
    auto& world = match.world_to_change();
    for (std::uint32_t player = 0; player < game::players; ++player) {
        const auto wizard = game::wizard_of(world, player);
        const double side = player == 0 ? 1 : -1;
        auto& motion = world.get<game::Motion>(wizard);
        motion.position = {10, motion.position.y, 1.5 * side};
        motion.velocity = {};
        match.physics().set_state(wizard.index, motion);
        world.get<game::Gaze>(wizard) = {side > 0 ? pi : 0, -0.2};
    }
}

/// Mouse and clutch: the hands go to and fro, the view to and fro more slowly.
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

/// Two hands that hold and move a thing each, all the time.
void tick_duel_haptic(const Options& options, Report& report) {
    auto scene = idle_match({"lift.energy.per_s=0", "lift.energy.per_n_s=0"});
    if (!scene) return;
    auto& match = *scene->match;
    match.live().timing = false;
    place_before_crates(match);
    scene->run(500);
    for (const auto button : {input::Button::wand_4, input::Button::fire}) {
        scene->frame = pressing(button);
        scene->run(100);
    }
    std::vector<double> samples(options.quick ? 20'000 : 120'000);
    double felt = 0, created = 0;
    const auto allocations = allocation_count();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        auto frame = scene->frame;
        shake_hands(i, frame);
        const double start = now_us();
        match.tick(frame);
        samples[i] = now_us() - start;
        felt +=
            static_cast<double>(match.felt(0)[match.match().played % std::tuple_size_v<game::ForceTrace>]);
    }
    const auto allocated = allocation_count() - allocations;
    int held = 0;
    match.world().view<const game::WandBelt, const game::Grip>().each(
        [&](ecs::Entity wizard, const game::WandBelt& belt, const game::Grip& grip) {
            held += game::wand_in_hand(match.data(), belt)->kind->held_at(match.world(), wizard) ? 1 : 0;
            created = std::max(created, grip.servo.energy.most_created);
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

/// One way to keep a feature busy: called before each tick.
using Stir = std::function<void(IdleMatch&, Tick)>;

struct Feature {
    const char* name;
    std::vector<std::string_view> systems;
    const char* idle_state;  ///< "absent" or "asleep"
    Stir stir;
};

struct Cost {
    double calls_per_tick{}, ns_per_tick{};
};

/// What the clock itself adds to the time of a system.
double clock_ns() {
    return 1000 *
           median_of(2000,
                     [] {
                         for (int i = 0; i < 10; ++i) do_not_optimise(now_us());
                     }) /
           10;
}

Cost cost_of(const Feature& feature, const Stir& stir, Tick count) {
    auto scene = idle_match();
    if (!scene) return {};
    if (stir) {
        for (Tick t = 0; t < 500; ++t) stir(*scene, t), scene->run(1);
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

void hold_fire(IdleMatch& scene, Tick) {
    for (auto& device : scene.frame.devices) device.buttons = 0;
    for (std::size_t d = 0; d < game::players; ++d) scene.frame.devices[d].press(input::Button::fire);
    auto& world = scene.match->world_to_change();
    world.view<game::WandBelt>().each([](game::WandBelt& belt) { belt.energy.fill(60); });
}

void kick_props(IdleMatch& scene, Tick tick) {
    if (tick % 200 != 0) return;
    auto& physics = scene.match->physics();
    scene.match->world().view<const game::Body, const game::Prop>().each(
        [&](ecs::Entity e, const game::Body& body, const game::Prop&) {
            physics.apply_central_impulse(e.index, vec3(0.5, 2, tick % 400 == 0 ? 0.7 : -0.7) * body.mass);
        });
}

void walk_about(IdleMatch& scene, Tick tick) {
    for (std::size_t d = 0; d < game::players; ++d) {
        scene.frame.devices[d].counts[input::hand::strafe] = tick % 1000 < 500 ? 127 : -127;
    }
}

void keep_dying(IdleMatch& scene, Tick tick) {
    if (tick % 4000 != 0) return;
    scene.match->world_to_change().view<game::Health>().each([](game::Health& h) { h.points = 0; });
}

void skip_features(const Options& options, Report& report) {
    const std::vector<Feature> features{
        {"missiles", {"bolts"}, "absent", hold_fire},
        {"resurrection", {"resurrection"}, "absent", keep_dying},
        {"bodies", {"physics", "places", "blows"}, "asleep", kick_props},
        {"wizards", {"walk", "physics", "places"}, "asleep", walk_about},
    };
    const Tick count = options.quick ? 4000 : 16'000;
    for (const auto& feature : features) {
        const Cost active = cost_of(feature, feature.stir, count);
        const Cost idle = cost_of(feature, nullptr, count);
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
    tick_alloc(options, report);
    tick_duel_haptic(options, report);
}

void replay(const Options& options, Report& report) { replay_verify(options, report); }

void skip(const Options& options, Report& report) { skip_features(options, report); }

}  // namespace thaum::bench
