// thaum range: practice against a dummy.
#include <algorithm>
#include <cstdio>
#include <random>

#include "core/text.h"
#include "game/app/command.h"
#include "game/app/content.h"
#include "game/bots/bot_file.h"
#include "game/command_line/arguments.h"
#include "game/live/live.h"
#include "game/range/range.h"
#include "render/display.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view range_help =
    R"(usage: thaum range [OPTIONS]

Practice with every wand against a dummy in an arena. No round ends, and a dead
wizard comes back. Nothing is recorded. So data files (wands, wizard, rules,
arena, range.toml) that change on disk are read again during practice. A faulty
file is reported, and its old numbers stay. The pause (Esc) can change the dummy.

  --apprentice     a course of short lessons, about three minutes: each step is shown until
                   it is done; the pause skips, repeats and leaves
  --dummy KIND     still (default), strafing: to and fro, shooting: at you
  --hands HAND     your device: mouse (default), half (the keypad), pad, or arm: a force
                   feedback arm with mouse and keyboard (arm:N: the arm of that number)

  --rules NAME     thaum (default), or classic: wands regain nothing, no shield
  --arena NAME     boiling_court (default), the_well, or another file in assets/arenas
  --set KEY=VALUE  changes one number of the data files, such as bolt.shot.damage=12
  --mutator NAME   a file in assets/mutators; may be repeated
  --seed N         seed of all random numbers
  --headless       no window: a bot practises, faster than real time, and the
                   score is printed; files are read once
  --bot BOT        that bot, by name or level (the strongest)
  --seconds S      ends after S seconds of match time; headless: 60
)";

constexpr Option range_options[] = {{"--apprentice"},       {"--dummy", 1},  {"--hands", 1},
                                    {"--rules", 1},         {"--arena", 1},  {"--set", 1, true},
                                    {"--mutator", 1, true}, {"--seed", 1},   {"--headless"},
                                    {"--bot", 1},           {"--seconds", 1}};

struct RangeOptions {
    DataChoice data;
    DummyKind dummy{};
    live::Seat hand{.kind = SeatKind::keyboard_mouse};
    bool headless = false, apprentice = false;
    std::string bot;  ///< name of the bot that practises (--headless)
    std::optional<std::uint64_t> seed;
    std::optional<double> seconds;
};

Expected<DummyKind> dummy_named(std::string_view word) {
    const auto& names = dummy_names;
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end())
        return fail(text("--dummy '", word, "': must be ", names[0], ", ", names[1], " or ", names[2]));
    return static_cast<DummyKind>(found - names.begin());
}

Expected<RangeOptions> read_range_options(const std::vector<std::string>& words) {
    const auto arguments = Arguments::parse(words, range_options);
    if (!arguments) return arguments.error();
    if (!arguments->plain().empty()) return fail(text("range takes no '", arguments->plain()[0], "'"));
    RangeOptions options;
    const auto dummy = dummy_named(arguments->value("--dummy").value_or("still"));
    if (!dummy) return dummy.error();
    options.dummy = *dummy;
    const auto hand = hand_named(arguments->value("--hands").value_or("mouse"));
    if (!hand) return hand.error();
    options.hand = *hand;
    options.headless = arguments->has("--headless");
    options.apprentice = arguments->has("--apprentice");
    if (options.apprentice && (options.headless || arguments->has("--dummy") || arguments->has("--arena")))
        return fail("--apprentice has its own dummy and arena: no --dummy, --arena or --headless");
    if (options.headless && arguments->has("--hands")) return fail("--headless has no player: no --hands");
    if (!options.headless && arguments->has("--bot")) return fail("--bot is for --headless");
    if (options.headless) {
        const auto word = arguments->value("--bot");
        const auto bot = word ? bot_named(find_assets(), *word) : strongest_bot(find_assets());
        if (!bot) return fail(text("--bot: ", bot.error().message));
        options.bot = *bot;
    }
    const auto seed = arguments->whole("--seed", 0, ~std::uint64_t{0});
    if (!seed) return seed.error();
    options.seed = *seed;
    const auto duration = arguments->number("--seconds", 0.001, 36000);
    if (!duration) return duration.error();
    options.seconds = *duration;
    options.data.rules = arguments->value("--rules").value_or(options.data.rules);
    options.data.arena = arguments->value("--arena").value_or(options.data.arena);
    options.data.overrides = arguments->values("--set");
    options.data.mutators = arguments->values("--mutator");
    return options;
}

int practise_off_screen(const RangeOptions& options, const RangeData& data) {
    const auto skill = load_bot_skill(find_assets(), options.bot);
    if (!skill) return refuse(skill.error());
    const auto seed = options.seed.value_or(1);
    auto range = make_range(data, bot_device(practising, options.bot), options.dummy, seed);
    Bots bots;
    bots.add(*range.match, practising, practising, *skill, seed);
    RangeScorer scorer;
    const auto end = ticks(options.seconds.value_or(60));
    for (Tick t = 0; t < end; ++t) {
        input::InputFrame frame;
        bots.sample(*range.match, frame);
        range.tick(frame.devices[practising]);
        scorer.score(*range.match);
    }
    std::printf("range: %s\n", words_of(scorer.score(*range.match)).c_str());
    std::printf("bot %s on the %s dummy, %s s; nothing is recorded\n", options.bot.c_str(),
                std::string(dummy_names[static_cast<std::size_t>(options.dummy)]).c_str(),
                fixed(seconds(end), 1).c_str());
    std::printf("state %s\n", hex(range.match->state_hash()).c_str());
    return done;
}

int practise_in_window(const RangeOptions& options, const RangeData& data) {
    const auto assets = find_assets();
    LivePlan plan;
    plan.data = data.match;
    plan.seed = options.seed.value_or(std::random_device{}());
    plan.practice = options.dummy;
    plan.apprentice = options.apprentice;
    plan.seats = {options.hand, live::Seat{.kind = SeatKind::dummy}};
    plan.assets = assets;
    plan.seconds = options.seconds;
    auto [settings, start_fault] = settings_to_play_with(settings_file(), assets);
    plan.settings = std::move(settings);
    plan.start_fault = std::move(start_fault);
    plan.read_all_data = [assets] { return short_words(check_content(assets)); };
    plan.settings_file = settings_file();
    return exit_code_of(run_live(plan));
}

int run_range(const std::vector<std::string>& words) {
    const auto options = read_range_options(words);
    if (!options) return refuse(options.error());
    if (!options->headless && !render::display_there())
        return refuse({"range needs a display; without one: thaum range --headless"});
    const auto data = load_range(find_assets(), options->data);
    if (!data) return refuse(data.error());
    return options->headless ? practise_off_screen(*options, *data) : practise_in_window(*options, *data);
}

const CommandRegistration registration_of_range({.name = "range", .help = range_help, .run = run_range});

}  // namespace

}  // namespace thaum::game::inline app
