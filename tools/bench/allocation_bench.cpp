// Benchmarks memory allocations in the ticks of a match. After a warm-up in which every kind of work has been
// done once, a tick must allocate nothing.
#include <algorithm>
#include <functional>

#include "core/file.h"
#include "core/text.h"
#include "game/bots/bot_file.h"
#include "game/components/casting.h"
#include "game/components/cauldron.h"
#include "game/components/orb.h"
#include "game/senses/senses.h"
#include "tests/scenes/carving_hands.h"
#include "tests/scenes/searching_hands.h"
#include "tests/scenes/stirring_hands.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/match_scene.h"

namespace thaum::bench {
namespace {

using game::Simulation;

/// Number of ticks before allocations are counted. By then every kind of work has been done once.
constexpr Tick warm_up = 10'000;

/// Numbers of memory allocations: by the match, by the bots, and by sound and tactile output.
struct Counted {
    std::uint64_t match{}, bots{}, senses{};
    std::uint64_t all() const { return match + bots + senses; }
};

/// Work that both wizards do for a while. If `frame` is set, it gives their input; otherwise their bots do.
struct Work {
    std::string_view name;
    std::function<void(Simulation&)> place{};              ///< moves both wizards to the place of their work
                                                           ///< (cauldron, orb or crystal)
    std::function<input::InputFrame(Tick)> frame{};        ///< input of both players
    std::function<void(Simulation&, Tick)> help{};         ///< gives directly what players would need long
                                                           ///< for, such as a carved crystal
    std::function<std::uint64_t(const Simulation&)> done;  ///< count of the work's results; it changes when
                                                           ///< work is done
    std::uint64_t times{};                                 ///< how often `done` has changed during this work
};

/// Ticks for which one kind of work is done. There are four kinds, so that the fourth ends with the warm-up.
constexpr Tick work_length = warm_up / 4;

/// Both players stir; in the second half of each second they draw a stroke on the brew.
input::InputFrame stir_and_draw(Tick tick) {
    auto frame = stirring(tick);
    for (std::size_t player = 0; player < game::players; ++player) {
        if (tick % 1000 >= 500) frame.devices[player].press(input::Button::trace);
        if (tick % 1000 >= 400 && tick % 1000 < 440) frame.devices[player].press(input::Button::fire);
    }
    return frame;
}

/// Puts an ingredient in the hands of the first wizard, who drops it into the brew a moment later.
void give_ingredient(Simulation& match, Tick tick) {
    if (tick % 1000 != 360) return;
    auto& world = match.world_to_change();
    const auto wizard = game::wizard_of(world, 0);
    const auto ingredient = static_cast<std::uint32_t>(tick / 1000 % 3);
    if (!world.has<game::Pouch>(wizard)) world.add(wizard, game::Pouch{.ingredient = ingredient});
}

/// Sets both crystals to completely carved at one tick, so that new crystals take their places.
void finish_key(Simulation& match, Tick tick) {
    if (tick != work_length / 2) return;
    match.world_to_change().view<game::Crystal>().each([](game::Crystal& crystal) { crystal.overlap = 1; });
}

/// Places both players side by side before the first crystal, on its side towards the middle of the arena.
void place_before_the_crystal(Simulation& match) {
    const vec3 middle = match.world().get<game::Crystal>(game::crystal_entity(match.world(), 0)).middle;
    const vec3 in = glm::normalize(-vec3(middle.x, 0, middle.z)), aside(in.z, 0, -in.x);
    for (std::uint32_t player = 0; player < game::players; ++player) {
        const vec3 at = middle + 1.3 * in + (player == 0 ? -0.5 : 0.5) * aside;
        stand(match, player, {at.x, match.data().wizard.height / 2, at.z});
    }
}

std::vector<Work> works_of(const game::MatchData& data, const ecs::World& world) {
    std::vector<Work> works;
    works.push_back({.name = "duel", .done = [](const Simulation& match) { return match.events().count(); }});
    if (data.cauldron)
        works.push_back(
            {.name = "brew",
             .place = [](Simulation& match) { place_at_the_rim(match); },
             .frame = stir_and_draw,
             .help = give_ingredient,
             .done = [](const Simulation& match) { return match.world().single<game::Cauldron>().stepped; }});
    if (world.count<game::Crystal>() > 0)
        works.push_back({.name = "crystal",
                         .place = place_before_the_crystal,
                         .frame = [](Tick tick) { return carving(tick); },
                         .help = finish_key,
                         .done =
                             [](const Simulation& match) {
                                 std::uint64_t edits = 0;
                                 match.world().view<const game::Crystal>().each(
                                     [&](const game::Crystal& crystal) { edits += crystal.edits; });
                                 return edits;
                             }});
    if (world.count<game::Orb>() > 0)
        works.push_back({.name = "orb",
                         .place = [](Simulation& match) { place_at_the_orb(match); },
                         .frame = searching,
                         .done =
                             [](const Simulation& match) {
                                 const bool searched = match.world().count<game::Scrying>() > 0;
                                 return searched ? match.now() : 0;
                             }});
    return works;
}

/// What is heard and felt of the match: the voices (playing sounds), and a jacket for each player. Another
/// thread mixes the samples of sounds; the area (group of benchmarks) `audio` measures that.
struct Output {
    std::unique_ptr<game::Senses> senses;
    tactile::Layout jacket;
    std::size_t layout = 0;
    std::uint64_t voices = 0, felt_frames = 0;

    Output(std::unique_ptr<game::Senses> both, tactile::Layout worn)
        : senses(std::move(both)), jacket(std::move(worn)) {
        layout = senses->add(jacket);
    }
    void follow(const Simulation& match) {
        senses->follow(match);
        if (match.now() % audio::frame_ticks != 0) return;
        voices += senses->heard().begins.count;
        for (std::uint32_t p = 0; p < game::players; ++p)
            felt_frames += senses->felt(p, layout).is_silent() ? 0 : 1;
    }
};

Expected<std::unique_ptr<Output>> make_output(const game::MatchData& data) {
    const auto assets = game::find_assets();
    auto sounds = game::SenseData::load(assets, audio::WithSamples::no);
    if (!sounds) return sounds.error();
    auto jacket = tactile::load_layout(assets / "tactile" / "layouts" / "x40.toml");
    if (!jacket) return jacket.error();
    return std::make_unique<Output>(game::Senses::create(*sounds, *data.presentation), std::move(*jacket));
}

/// A duel of bots that is interrupted by work at the stations (cauldron, crystal, orb). Sound and tactile
/// output of the match are computed, too.
class BusyMatch {
public:
    BusyMatch(game::BotDuel duel, std::unique_ptr<Output> output)
        : duel_(std::move(duel)),
          output_(std::move(output)),
          works_(works_of(duel_.match->data(), duel_.match->world())) {}

    /// Plays `count` ticks, either with all kinds of work in turn or with the duel alone.
    Counted run(Tick count, bool all_works) {
        Counted counted;
        const Tick works = all_works ? works_.size() : 1;
        for (Tick t = 0; t < count; ++t) tick(works_[t / work_length % works], t % work_length, counted);
        return counted;
    }
    void forget_what_was_done() {
        for (auto& work : works_) work.times = 0;
    }

    const Simulation& match() const { return *duel_.match; }
    const Output& output() const { return *output_; }
    std::span<const Work> works() const { return works_; }

private:
    void tick(Work& work, Tick tick, Counted& counted) {
        auto& match = *duel_.match;
        if (work.place) prepare(work, tick);
        const auto before = work.done(match);
        auto start = allocation_count();
        const auto since = [&] {
            const auto count = allocation_count() - start;
            start += count;
            return count;
        };
        auto frame = duel_.next_frame();
        counted.bots += since();
        if (work.frame) frame = work.frame(tick);
        since();
        match.tick(frame);
        counted.match += since();
        output_->follow(match);
        counted.senses += since();
        work.times += work.done(match) != before ? 1 : 0;
    }
    /// Moves the wizards to the place of their work, unless one is dead, and keeps them able to do it.
    void prepare(const Work& work, Tick tick) {
        auto& match = *duel_.match;
        auto& world = match.world_to_change();
        world.view<game::Health, ecs::Without<game::Dead>>().each(
            [&](game::Health& health) { health.points = match.data().wizard.health; });
        world.view<game::Focus>().each([](game::Focus& focus) { focus.points = 100; });
        if (world.count<game::Dead>() > 0) return;
        if (tick % 500 == 0) work.place(match);
        if (work.help) work.help(match, tick);
    }

    game::BotDuel duel_;
    std::unique_ptr<Output> output_;
    std::vector<Work> works_;
};

/// A duel of the best bots, whose hands may also cast spells without a button, so that all their motion is
/// read for gestures.
Expected<game::BotDuel> gesturing_duel(std::shared_ptr<const game::MatchData> data) {
    const auto bot = game::strongest_bot(game::find_assets());
    if (!bot) return bot.error();
    const auto skill = game::load_bot_skill(game::find_assets(), *bot);
    if (!skill) return skill.error();
    game::MatchSetup setup{.seed = 1, .devices = {}};
    for (std::uint32_t player = 0; player < game::players; ++player) {
        setup.devices.push_back(game::bot_device(player, *bot));
        setup.devices.back().casts_freely = true;
    }
    game::BotDuel duel{std::make_unique<Simulation>(std::move(data), std::move(setup)), {}};
    for (std::uint32_t player = 0; player < game::players; ++player)
        duel.bots.add(*duel.match, player, player, *skill, 1);
    return duel;
}

Expected<std::unique_ptr<BusyMatch>> busy_match(const std::string& arena) {
    auto data = duel_data({}, arena);
    if (!data) return fail("the data files could not be loaded; see the message above");
    auto duel = gesturing_duel(data);
    if (!duel) return duel.error();
    auto output = make_output(*data);
    if (!output) return output.error();
    return std::make_unique<BusyMatch>(std::move(*duel), std::move(*output));
}

Row allocation_row(const std::string& arena, bool all_works, const BusyMatch& busy, const Counted& first,
                   const Counted& counted, Tick ticks) {
    Row row{.area = "tick", .name = "alloc"};
    row.setting = {{"arena", arena},
                   {"scene", std::string(all_works ? "everything" : "bots")},
                   {"after_s", static_cast<std::int64_t>(seconds(warm_up))}};
    std::uint32_t shots = 0, idle = 0;
    busy.match().world().view<const game::WandBelt>().each(
        [&](const game::WandBelt& belt) { shots += belt.fired; });
    row.metrics = {{"allocations", static_cast<double>(counted.all())},
                   {"by_match", static_cast<double>(counted.match)},
                   {"by_bots", static_cast<double>(counted.bots)},
                   {"by_senses", static_cast<double>(counted.senses)},
                   {"before", static_cast<double>(first.all())},
                   {"counted", allocations_are_counted() ? 1.0 : 0.0},
                   {"ticks", static_cast<double>(ticks)},
                   {"shots", static_cast<double>(shots)},
                   {"voices", static_cast<double>(busy.output().voices)},
                   {"felt_frames", static_cast<double>(busy.output().felt_frames)}};
    for (const auto& work : busy.works().first(all_works ? busy.works().size() : 1)) {
        row.metrics.emplace_back(text("ticks_of_", work.name), static_cast<double>(work.times));
        idle += work.times == 0 ? 1 : 0;
    }
    row.metrics.emplace_back("idle_works", static_cast<double>(idle));
    return row;
}

void count_allocations(const Options& options, const std::string& arena, bool all_works, Report& report) {
    auto made = busy_match(arena);
    if (!there(made, "tick/alloc")) return;
    auto& busy = **made;
    // The readers of gestures are made before the first tick, as for a match in a window.
    if (const auto& gestures = busy.match().data().gestures) {
        (void)gestures->recogniser();
        (void)gestures->motion_recogniser();
    }
    const auto first = busy.run(warm_up, all_works);
    busy.forget_what_was_done();
    const Tick ticks = options.quick ? 20'000 : 60'000;
    const auto counted = busy.run(ticks, all_works);
    report.rows.push_back(allocation_row(arena, all_works, busy, first, counted, ticks));
}

}  // namespace

void tick_allocations(const Options& options, Report& report) {
    const auto arenas = files_in(game::find_assets() / "arenas", ".toml");
    if (!there(arenas, "tick/alloc")) return;
    for (const auto& file : *arenas) {
        for (const bool all_works : {false, true})
            count_allocations(options, file.stem().string(), all_works, report);
    }
}

}  // namespace thaum::bench
