// thaum play: plays a match.
#include <algorithm>
#include <cstdio>
#include <random>

#include "core/text.h"
#include "game/app/command.h"
#include "game/app/content.h"
#include "game/app/offscreen_duel.h"
#include "game/bots/bot_file.h"
#include "game/command_line/arguments.h"
#include "game/live/live.h"
#include "render/display.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view play_help =
    R"(usage: thaum [play] [--vs | --solo BOT | --demo] [OPTIONS]

A duel in a window; without a display two bots play as with --headless.
Every match is recorded; `thaum replay` plays it again.
Without --vs, --solo or --demo it begins with the start screen: press to join.

  --vs             two players: mouse and keyboard against a pad, or against the
                   keypad if there is no pad
  --solo BOT       against a bot: a file in assets/bots, or a level, from 0 (easiest) on
  --demo           two bots, one match after another, until Q leaves
  --hands A[,B]    the players' devices: mouse, half (the keypad), pad, or arm: a force
                   feedback arm and the mouse (second arm: pad or keypad). arm:0,arm:1:
                   arms by number in `thaum doctor`. Arms also go with the start screen
  --bots A,B       bots of --demo and --headless, by name or level (1,1)

  --rules NAME     thaum (default), or classic: no regain, shield or surge
  --match NAME     quick (default): first to 3, 4 min; standard: best of 3 rounds,
                   each first to 5, 6 min
  --set KEY=VALUE  changes one number of the data files, such as bolt.shot.damage=12
  --mutator NAME   low_gravity, fog, or another file in assets/mutators; may be repeated
  --arena NAME     boiling_court (default), the_well, or another file in assets/arenas
  --seed N         seed of all random numbers;  --record FILE  the log (a new file)
  --headless       no window: two bots, faster than real time
  --seconds S      ends after S s of match time; headless: 60; no display: a round
  --out DIR        folder for the files of --headless: duel.png, duel.thaumlog, duel.txt;
                   older ones are replaced (out)
)";

constexpr Option play_options[] = {
    {"--vs"},       {"--solo", 1},      {"--demo"},     {"--hands", 1},     {"--bots", 1},
    {"--rules", 1}, {"--match", 1},     {"--arena", 1}, {"--set", 1, true}, {"--mutator", 1, true},
    {"--seed", 1},  output("--record"), {"--headless"}, {"--seconds", 1},   {"--out", 1}};

/// Checked options of the command line.
struct PlayOptions {
    DataChoice data;
    std::optional<std::uint64_t> seed;
    std::optional<double> seconds;
    std::filesystem::path record, out = "out";
    bool headless = false, demo = false, vs = false;
    bool match_named = false, mutators_named = false,
         /// true if an option names the arena; otherwise the last choice on the start screen is used
        arena_named = false;
    std::optional<std::string> solo;  ///< name of the bot (--solo); std::nullopt without --solo
    std::vector<live::Seat> hands;
    std::array<std::string, players> bots{"1", "1"};  ///< by name or level

    bool mode() const { return demo || vs || solo.has_value(); }
};

/// Names of the bots of `words`, such as "2,3" or "level_2,level_3".
Expected<std::array<std::string, players>> read_bots(std::string_view words) {
    const auto parts = parts_of(words);
    if (parts.size() != players) return fail("--bots needs two bots, such as 2,3");
    std::array<std::string, players> names;
    for (std::size_t i = 0; i < players; ++i) {
        auto name = bot_named(find_assets(), parts[i]);
        if (!name) return fail(text("--bots: ", name.error().message));
        names[i] = std::move(*name);
    }
    return names;
}

/// Reads who plays: two people, one against a bot, or two bots.
Expected<void> read_mode(const Arguments& arguments, PlayOptions& options) {
    options.headless = arguments.has("--headless");
    options.demo = arguments.has("--demo");
    if (const auto word = arguments.value("--solo")) {
        const auto name = bot_named(find_assets(), *word);
        if (!name) return fail(text("--solo: ", name.error().message));
        options.solo = *name;
    }
    options.vs = arguments.has("--vs");
    const int ways = (options.vs ? 1 : 0) + (options.demo ? 1 : 0) + (options.solo ? 1 : 0);
    if (ways > 1) return fail("--vs, --solo and --demo exclude each other");
    if (options.headless && (options.vs || options.solo))
        return fail("--headless plays two bots: no --vs or --solo");
    return {};
}

/// Reads the players' devices. Call read_mode first.
Expected<void> read_hands(const Arguments& arguments, PlayOptions& options) {
    const auto words = arguments.value("--hands");
    if (!words) return {};
    const auto hands = hands_named(*words);
    if (!hands) return hands.error();
    options.hands = *hands;
    const bool only_arms =
        std::all_of(hands->begin(), hands->end(), [](const live::Seat& seat) { return seat.arm; });
    const bool start_screen = !options.mode() && !options.headless && only_arms;
    if (!options.vs && !options.solo && !start_screen) return fail("--hands goes with --vs or --solo");
    if (options.solo && options.hands.size() > 1) return fail("--solo has one player: one hand");
    return {};
}

Expected<PlayOptions> read_play_options(const std::vector<std::string>& words) {
    const auto arguments = Arguments::parse(words, play_options);
    if (!arguments) return arguments.error();
    if (!arguments->plain().empty()) return fail(text("play takes no '", arguments->plain()[0], "'"));
    PlayOptions options;
    if (const auto mode = read_mode(*arguments, options); !mode) return mode.error();
    if (const auto hands = read_hands(*arguments, options); !hands) return hands.error();
    if (const auto words = arguments->value("--bots")) {
        if (!options.demo && !options.headless) return fail("--bots is for --demo and --headless");
        const auto bots = read_bots(*words);
        if (!bots) return bots.error();
        options.bots = *bots;
    }
    const auto seed = arguments->whole("--seed", 0, ~std::uint64_t{0});
    if (!seed) return seed.error();
    options.seed = *seed;
    const auto duration = arguments->number("--seconds", 0.001, 36000);
    if (!duration) return duration.error();
    options.seconds = *duration;
    options.data.rules = arguments->value("--rules").value_or(options.data.rules);
    options.data.match = arguments->value("--match").value_or(options.data.match);
    options.data.arena = arguments->value("--arena").value_or(options.data.arena);
    options.match_named = arguments->has("--match");
    options.arena_named = arguments->has("--arena");
    options.data.overrides = arguments->values("--set");
    options.data.mutators = arguments->values("--mutator");
    options.mutators_named = arguments->has("--mutator");
    options.record = arguments->value("--record").value_or("");
    options.out = arguments->value("--out").value_or(options.out.string());
    return options;
}

/// Plays a whole round without a display. If the options ask for nothing else, it is a round between good
/// bots that ends with a winner.
int play_off_screen(const PlayOptions& options) {
    constexpr double longest_round = 600;  // longest simulated time of one round (s)
    constexpr std::uint64_t seed_with_winner = 5;
    const bool any = !options.headless && !options.mode();
    auto bots = options.bots;
    // Without any bot that can be read, the duel tells why.
    if (const auto best = strongest_bot(find_assets()); any && best) bots.fill(*best);
    return play_offscreen_duel({.assets = find_assets(),
                                .out = options.out,
                                .log = options.record,
                                .data = options.data,
                                .seed = options.seed.value_or(any ? seed_with_winner : 1),
                                .bots = bots,
                                .seconds = options.seconds.value_or(options.headless ? 60 : longest_round)});
}

std::array<live::Seat, 2> seats_of(const PlayOptions& options) {
    if (options.demo)
        return {live::Seat{.kind = SeatKind::bot, .bot = options.bots[0]},
                live::Seat{.kind = SeatKind::bot, .bot = options.bots[1]}};
    const auto hand = [&](std::size_t i, SeatKind otherwise) {
        return i < options.hands.size() ? options.hands[i] : live::Seat{.kind = otherwise};
    };
    const auto first = hand(0, SeatKind::keyboard_mouse);
    if (options.solo) return {first, live::Seat{.kind = SeatKind::bot, .bot = *options.solo}};
    return {first, hand(1, SeatKind::pad_or_half)};
}

/// Data for the start screen: its last choice, unless options name a match, an arena or mutators. If that
/// choice can no longer be loaded, mutators are left out, and if that does not help, the default is used.
Expected<MatchData> load_last_choice(const std::filesystem::path& assets, const PlayOptions& options,
                                     const LastChoice& last) {
    auto choice = options.data;
    if (!options.match_named) choice.match = last.match;
    if (!options.arena_named) choice.arena = last.arena;
    if (!options.mutators_named) choice.mutators = last.mutators;
    auto data = load_match_data(assets, choice);
    if (data) return data;
    choice.mutators = options.data.mutators;
    data = load_match_data(assets, choice);
    return data ? std::move(data) : load_match_data(assets, options.data);
}

int play_in_window(const PlayOptions& options) {
    const auto assets = find_assets();
    std::error_code no_file;
    const bool first_start = !std::filesystem::exists(settings_file(), no_file);
    auto [settings, start_fault] = settings_to_play_with(settings_file(), assets);
    auto data = options.mode() ? load_match_data(assets, options.data)
                               : load_last_choice(assets, options, settings.last);
    if (!data) return refuse(data.error());
    LivePlan plan;
    plan.data = std::make_shared<const MatchData>(std::move(*data));
    plan.seed = options.seed.value_or(std::random_device{}());
    plan.seats = seats_of(options);
    plan.start_screen = !options.mode();
    plan.first_start = first_start;
    plan.demo = options.demo;
    plan.assets = assets;
    plan.seconds = options.seconds;
    plan.log = options.record;
    plan.logs_folder = matches_folder();
    if (plan.logs_folder.empty() && plan.log.empty())
        std::fprintf(
            stderr, "this match is not recorded: there is no home folder; set HOME, or give --record FILE\n");
    plan.settings = std::move(settings);
    plan.start_fault = std::move(start_fault);
    plan.read_all_data = [assets] { return short_words(check_content(assets)); };
    plan.settings_file = settings_file();
    return exit_code_of(run_live(plan));
}

int run_play(const std::vector<std::string>& words) {
    const auto options = read_play_options(words);
    if (!options) return refuse(options.error());
    if (!options->headless && !render::display_there()) {
        if (options->solo) return refuse({"--solo needs a display; without one: thaum --headless"});
        std::printf("no display%s: two bots play off-screen\n",
                    render::display_not_spoken().empty() ? "" : " (Wayland alone; windows need X11)");
        return play_off_screen(*options);
    }
    return options->headless ? play_off_screen(*options) : play_in_window(*options);
}

const CommandRegistration registration_of_play({.name = "play", .help = play_help, .run = run_play});

}  // namespace

}  // namespace thaum::game::inline app
