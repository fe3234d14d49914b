// thaum play: plays a match.
#include <algorithm>
#include <cstdio>
#include <random>

#include "core/text.h"
#include "game/app/arguments.h"
#include "game/app/command.h"
#include "game/app/live.h"
#include "game/app/offscreen_duel.h"
#include "game/bots/bot.h"

namespace thaum::app {
namespace {

constexpr std::string_view play_help =
    R"(usage: thaum [play] [--vs | --solo LEVEL | --demo] [OPTIONS]

A duel in a window. Every match is recorded; `thaum replay` plays it again.
Without --vs, --solo or --demo it begins with the start screen: press to join.

  --vs             two players: mouse and keyboard against a pad, or against the
                   keypad if there is no pad
  --solo LEVEL     against a bot of level 1, 2 or 3
  --demo           two bots
  --hands A[,B]    the players' devices: mouse, half (the keypad), pad, or arm: a force
                   feedback arm (OpenHaptics) with mouse and keyboard. `--hands arm` also
                   works with the start screen: the player with the mouse holds the arm
  --bots A,B       levels of the bots of --demo and --headless (1,1)

  --rules NAME     thaum (default), or classic: wands regain nothing, no shield
  --match NAME     quick (default): first to 3, 4 min; standard: best of 3 rounds,
                   each first to 5, 6 min; a tied round counts for nobody
  --set KEY=VALUE  changes one number of the data files, such as bolt.shot.damage=12
  --arena NAME     boiling_court (default), the_well, or another file in assets/arenas
  --seed N         seed of all random numbers
  --record FILE    file for the log; default: a new file in the data folder
  --headless       no window: two bots, faster than real time
  --seconds S      ends after S seconds of match time; headless: 60
  --out DIR        folder for the files of --headless: duel.png, duel.thaumlog, duel.txt;
                   older ones are replaced (out)

Without a display two bots play as with --headless, and a line says so.
)";

constexpr Option play_options[] = {{"--vs"},           {"--solo", 1},  {"--demo"},      {"--hands", 1},
                                   {"--bots", 1},      {"--rules", 1}, {"--match", 1},  {"--arena", 1},
                                   {"--set", 1, true}, {"--seed", 1},  {"--record", 1}, {"--headless"},
                                   {"--seconds", 1},   {"--out", 1}};

/// Checked options of the command line.
struct Wish {
    game::DataChoice data;
    std::optional<std::uint64_t> seed;
    std::optional<double> seconds;
    std::filesystem::path record, out = "out";
    bool headless = false, demo = false, vs = false;
    std::optional<int> solo;  ///< level of the bot; std::nullopt: not --solo
    std::vector<Seat> hands;
    std::array<int, game::players> bots{1, 1};

    bool mode() const { return demo || vs || solo.has_value(); }
};

Expected<std::vector<Seat>> hands_of(std::string_view words) {
    std::vector<Seat> hands;
    for (;;) {
        const auto comma = std::min(words.find(','), words.size());
        const auto word = words.substr(0, comma);
        const auto hand = hand_named(word);
        if (!hand) return tl::unexpected(hand.error());
        hands.push_back(*hand);
        if (comma == words.size()) break;
        words.remove_prefix(comma + 1);
    }
    const bool twice = hands.size() == 2 && hands[0].kind == hands[1].kind && hands[0].kind != SeatKind::pad;
    if (hands.size() > 2 || twice)
        return fail("--hands takes one or two, and the same only if pads; arm needs the mouse");
    return hands;
}

/// Levels of two bots: "2,3".
Expected<std::array<int, game::players>> read_bots(std::string_view words) {
    const auto comma = words.find(',');
    if (comma == std::string_view::npos) return fail("--bots needs two levels, such as 2,3");
    const auto first = parse_whole(words.substr(0, comma), "--bots", 1, game::bot_levels);
    if (!first) return tl::unexpected(first.error());
    const auto second = parse_whole(words.substr(comma + 1), "--bots", 1, game::bot_levels);
    if (!second) return tl::unexpected(second.error());
    return std::array{static_cast<int>(*first), static_cast<int>(*second)};
}

Expected<Wish> read_wish(const std::vector<std::string>& words) {
    const auto arguments = Arguments::parse(words, play_options);
    if (!arguments) return tl::unexpected(arguments.error());
    if (!arguments->plain().empty()) return fail(text("play takes no '", arguments->plain()[0], "'"));
    Wish wish;
    wish.headless = arguments->has("--headless");
    wish.demo = arguments->has("--demo");
    const auto level = arguments->whole("--solo", 1, game::bot_levels, 1);
    if (!level) return tl::unexpected(level.error());
    if (arguments->has("--solo")) wish.solo = static_cast<int>(*level);
    wish.vs = arguments->has("--vs");
    const int ways = (wish.vs ? 1 : 0) + (wish.demo ? 1 : 0) + (wish.solo ? 1 : 0);
    if (ways > 1) return fail("--vs, --solo and --demo exclude each other");
    if (wish.headless && (wish.vs || wish.solo)) return fail("--headless plays two bots: no --vs or --solo");
    if (const auto words = arguments->value("--hands")) {
        const auto hands = hands_of(*words);
        if (!hands) return tl::unexpected(hands.error());
        wish.hands = *hands;
        const bool start_screen = !wish.mode() && !wish.headless && hands->size() == 1 && hands->front().arm;
        if (!wish.vs && !wish.solo && !start_screen) return fail("--hands goes with --vs or --solo");
        if (wish.solo && wish.hands.size() > 1) return fail("--solo has one player: one hand");
    }
    const auto bots = read_bots(arguments->value("--bots").value_or("1,1"));
    if (!bots) return tl::unexpected(bots.error());
    wish.bots = *bots;
    if (arguments->has("--bots") && !wish.demo && !wish.headless)
        return fail("--bots is for --demo and --headless");
    const auto seed = arguments->whole("--seed", 0, ~std::uint64_t{0});
    if (!seed) return tl::unexpected(seed.error());
    wish.seed = *seed;
    const auto duration = arguments->number("--seconds", 0.001, 36000);
    if (!duration) return tl::unexpected(duration.error());
    wish.seconds = *duration;
    wish.data.rules = arguments->value("--rules").value_or(wish.data.rules);
    wish.data.match = arguments->value("--match").value_or(wish.data.match);
    wish.data.arena = arguments->value("--arena").value_or(wish.data.arena);
    wish.data.overrides = arguments->values("--set");
    wish.record = arguments->value("--record").value_or("");
    wish.out = arguments->value("--out").value_or(wish.out.string());
    return wish;
}

int play_off_screen(const Wish& wish) {
    return play_offscreen_duel({.assets = game::find_assets(),
                                .out = wish.out,
                                .log = wish.record,
                                .data = wish.data,
                                .seed = wish.seed.value_or(1),
                                .levels = wish.bots,
                                .seconds = wish.seconds.value_or(60)});
}

std::array<Seat, 2> seats_of(const Wish& wish) {
    if (wish.demo)
        return {Seat{.kind = SeatKind::bot, .level = wish.bots[0]},
                Seat{.kind = SeatKind::bot, .level = wish.bots[1]}};
    const auto hand = [&](std::size_t i, SeatKind otherwise) {
        return i < wish.hands.size() ? wish.hands[i] : Seat{.kind = otherwise};
    };
    const auto first = hand(0, SeatKind::keyboard_mouse);
    if (wish.solo) return {first, Seat{.kind = SeatKind::bot, .level = *wish.solo}};
    return {first, hand(1, SeatKind::pad_or_half)};
}

int play_in_window(const Wish& wish) {
    const auto assets = game::find_assets();
    auto settings = settings_to_play_with(settings_file(), assets);
    auto data = game::load_match_data(assets, wish.data);
    if (!data) return refuse(data.error());
    LivePlan plan;
    plan.data = std::make_shared<const game::MatchData>(std::move(*data));
    plan.seed = wish.seed.value_or(std::random_device{}());
    plan.seats = seats_of(wish);
    plan.start_screen = !wish.mode();
    plan.assets = assets;
    plan.seconds = wish.seconds;
    plan.log = wish.record;
    plan.logs_folder = matches_folder();
    if (plan.logs_folder.empty() && plan.log.empty())
        std::fprintf(
            stderr, "this match is not recorded: there is no home folder; set HOME, or give --record FILE\n");
    plan.settings = std::move(settings);
    plan.settings_file = settings_file();
    return run_live(plan);
}

int run_play(const std::vector<std::string>& words) {
    const auto wish = read_wish(words);
    if (!wish) return refuse(wish.error());
    if (!wish->headless && !display_there()) {
        if (wish->solo) return refuse({"--solo needs a display; without one: thaum --headless"});
        std::printf("no display: two bots play off-screen\n");
        return play_off_screen(*wish);
    }
    return wish->headless ? play_off_screen(*wish) : play_in_window(*wish);
}

}  // namespace

Command play_command() {
    return {"play", "a match: the start screen, or --vs, --solo LEVEL, --demo", play_help, run_play};
}

}  // namespace thaum::app
