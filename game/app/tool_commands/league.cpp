// thaum league: matches between all bots. The results show whether a higher level plays better and whether
// matches have the wanted length. A match depends only on its data and seed, so any process may play it.
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "core/file.h"
#include "core/json.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "core/threads.h"
#include "game/app/command.h"
#include "game/bots/bot_file.h"
#include "game/bots/league.h"
#include "game/command_line/arguments.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view league_help =
    R"(usage: thaum league [OPTIONS]

Plays matches between every two bots; each seed twice, with the sides swapped.
A single bot plays against itself, each seed once.

  --bots A,B,..    bots, by name or level, the weakest first (all of assets/bots)
  --matches N      matches of each two bots (20)
  --rules NAME, --match NAME, --arena NAME, --set KEY=VALUE,
  --mutator NAME   as in `thaum play`
  --seed N         seed of the first match (1);  --jobs N  processes (one a core)
  --table balance  in place of who wins: how often pot, spells, orb and crystal are
                   used, which kills are magic, and how long they take
  --json FILE      all of it as JSON, replacing an older one; - for stdout
  --check          exit code 1 unless each bot wins 60 to 85 % against the one
                   before it and the median round takes 100 to 240 s

The same options give the same table with any number of processes. A draw is half a win
for each; dry: alive without energy for a shot; own: a death that is nobody's kill.
Magic is used in a round if it heals, pushes or holds off a blow, or if a blow falls
while it acts. A kill is magic if at least half of the last 30 HP was lost by magic or
under it: a potion or the Lens of the killer, 6 s after a spell, 2 s after a push.
)";

constexpr Option league_options[] = {{"--bots", 1},          {"--matches", 1}, {"--rules", 1},
                                     {"--match", 1},         {"--arena", 1},   {"--set", 1, true},
                                     {"--mutator", 1, true}, {"--seed", 1},    {"--jobs", 1},
                                     {"--table", 1},         output("--json"), {"--check"}};

struct Plan {
    std::vector<std::string> bots;  // names, the weakest first
    std::uint64_t matches = 20, seed = 1, jobs = 1;
    DataChoice choice{};
    std::string json;
    bool check = false;
    bool balance = false;  // the text is the table of the balance
};

/// Names of the league's bots. Each is loaded once, so that a fault is reported here and not in a child
/// process.
Expected<std::vector<std::string>> read_bots(const std::optional<std::string>& words) {
    const auto assets = find_assets();
    std::vector<std::string> chosen;
    if (words) {
        chosen = parts_of(*words);
    } else {
        for (const auto& bot : list_bots(assets)) chosen.push_back(bot.name);
    }
    std::vector<std::string> names;
    for (const auto& word : chosen) {
        const auto bot = load_bot(assets, word);
        if (!bot) return bot.error();
        if (std::ranges::find(names, bot->name) != names.end())
            return fail(text("--bots names ", bot->name, " twice; it needs different bots, or a single one"));
        names.push_back(bot->name);
    }
    if (names.empty()) return fail(text(shown_path(assets, "bots"), ": the folder has no bot, NAME.toml"));
    return names;
}

Expected<Plan> read_plan(const std::vector<std::string>& words) {
    const auto arguments = Arguments::parse(words, league_options);
    if (!arguments) return arguments.error();
    if (!arguments->plain().empty()) return fail(text("league takes no '", arguments->plain()[0], "'"));
    Plan plan;
    auto bots = read_bots(arguments->value("--bots"));
    if (!bots) return bots.error();
    plan.bots = std::move(*bots);
    const auto matches = arguments->whole("--matches", 1, 100'000, plan.matches);
    if (!matches) return matches.error();
    plan.matches = *matches;
    const auto seed = arguments->whole("--seed", 0, ~std::uint64_t{0} / 2, plan.seed);
    if (!seed) return seed.error();
    plan.seed = *seed;
    const auto jobs = arguments->whole("--jobs", 1, 256, processors());
    if (!jobs) return jobs.error();
    plan.jobs = *jobs;
    plan.choice.rules = arguments->value("--rules").value_or(plan.choice.rules);
    plan.choice.match = arguments->value("--match").value_or(plan.choice.match);
    plan.choice.arena = arguments->value("--arena").value_or(plan.choice.arena);
    plan.choice.overrides = arguments->values("--set");
    plan.choice.mutators = arguments->values("--mutator");
    const auto table = arguments->value("--table");
    if (table && *table != "balance") return fail(text("--table is balance, not '", *table, "'"));
    plan.balance = table.has_value();
    plan.json = arguments->value("--json").value_or("");
    plan.check = arguments->has("--check");
    return plan;
}

// Playing ---------------------------------------------------------------------------------------------------

struct Fixture {
    std::array<std::int32_t, players> bots{};  ///< places in Plan::bots
    std::uint64_t seed{};
};

std::vector<Fixture> fixtures_of(const Plan& plan) {
    std::vector<Fixture> fixtures;
    const auto count = static_cast<std::int32_t>(plan.bots.size());
    if (count == 1) {
        for (std::uint64_t i = 0; i < plan.matches; ++i) fixtures.push_back({{0, 0}, plan.seed + i});
    }
    for (std::int32_t low = 0; low < count; ++low) {
        for (std::int32_t high = low + 1; high < count; ++high) {
            for (std::uint64_t i = 0; i < plan.matches; ++i) {
                Fixture f{{low, high}, plan.seed + i / 2};
                if (i % 2 == 1) std::swap(f.bots[0], f.bots[1]);
                fixtures.push_back(f);
            }
        }
    }
    return fixtures;
}

bool write_all(int to, const LeagueMatch& match) {
    const auto* bytes = reinterpret_cast<const char*>(&match);
    for (std::size_t done = 0; done < sizeof match;) {
        const auto written = ::write(to, bytes + done, sizeof match - done);
        if (written <= 0) return false;
        done += static_cast<std::size_t>(written);
    }
    return true;
}

bool read_all(int from, LeagueMatch& match) {
    auto* bytes = reinterpret_cast<char*>(&match);
    for (std::size_t done = 0; done < sizeof match;) {
        const auto got = ::read(from, bytes + done, sizeof match - done);
        if (got <= 0) return false;
        done += static_cast<std::size_t>(got);
    }
    return true;
}

using Data = std::shared_ptr<const MatchData>;

/// Body of a child process: plays every `jobs`-th match and sends the results to the parent.
[[noreturn]] void work(const Plan& plan, const Data& data, const std::vector<Fixture>& fixtures,
                       std::size_t job, int to) {
    const auto assets = find_assets();
    for (std::size_t i = job; i < fixtures.size(); i += plan.jobs) {
        const auto match = play_league_match(assets, data, plan.bots, fixtures[i].bots, fixtures[i].seed);
        if (!match || !write_all(to, *match)) ::_exit(does_not_hold);
    }
    ::_exit(done);
}

struct Worker {
    pid_t process{};
    int from{};
};

Expected<Worker> start(const Plan& plan, const Data& data, const std::vector<Fixture>& fixtures,
                       std::size_t job) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return fail("league: no pipe to a process");
    const auto parent = ::getpid();
    const auto process = ::fork();
    if (process < 0) return fail("league: cannot start a process; try fewer --jobs");
    if (process == 0) {
        ::close(ends[0]);
        // Ends the worker with its parent. The parent may even have been killed before this line.
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(does_not_hold);
        work(plan, data, fixtures, job, ends[1]);
    }
    ::close(ends[1]);
    return Worker{process, ends[0]};
}

Expected<std::vector<LeagueMatch>> play(const Plan& plan, const Data& data) {
    const auto fixtures = fixtures_of(plan);
    const auto jobs = std::min<std::size_t>(plan.jobs, fixtures.size());
    std::fflush(nullptr);  // otherwise each process would write the buffered output again
    std::vector<Worker> workers;
    std::optional<Error> error;
    Plan shared = plan;
    shared.jobs = jobs;
    for (std::size_t job = 0; job < jobs && !error; ++job) {
        auto worker = start(shared, data, fixtures, job);
        if (worker)
            workers.push_back(*worker);
        else
            error = worker.error();
    }
    std::vector<LeagueMatch> matches(fixtures.size());
    for (std::size_t job = 0; job < workers.size(); ++job) {
        for (std::size_t i = job; i < fixtures.size() && !error; i += jobs) {
            if (!read_all(workers[job].from, matches[i]))
                error = Error{text("league: the process that played match ", i + 1, " has failed")};
        }
        ::close(workers[job].from);
    }
    for (const auto& worker : workers) ::waitpid(worker.process, nullptr, 0);
    if (error) return *error;
    return matches;
}

// Results ------------------------------------------------------------------------------------------------

double at_share(const std::vector<double>& sorted, double share) {
    return sorted.empty() ? 0
                          : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

double ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

std::string percent(double share) { return text(fixed(100 * share, 0), " %"); }

double time_out_share(const LeagueSummary& s) {
    return ratio(s.timed_out, static_cast<double>(s.round_s.size()));
}

std::string headline(const Plan& plan) {
    return text("league   rules ", plan.choice.rules, ", match ", plan.choice.match, ", arena ",
                plan.choice.arena, ", ", plan.matches, " matches of each two, seeds from ", plan.seed, "\n");
}

std::string seats_and_rounds(const LeagueSummary& s) {
    return text("seats    player 1 won ", s.seat_wins[0], ", player 2 won ", s.seat_wins[1], "\nrounds   ",
                s.round_s.size(), ", median ", fixed(s.median_round_s(), 0), " s, ",
                percent(time_out_share(s)), " ended by time\n");
}

/// Shares of the kills by their cause.
std::string kill_shares(const LeagueSummary& s) {
    std::string line = "kills    ";
    double all = s.own_deaths;
    for (const auto kills : s.kills) all += kills;
    for (std::size_t cause = 0; cause < causes().size(); ++cause)
        if (!causes()[cause].empty())
            line += text(causes()[cause], " ", percent(ratio(s.kills[cause], all)), ", ");
    return line + text("own ", percent(ratio(s.own_deaths, all)), "\n");
}

std::string balance_table(const Plan& plan, const LeagueSummary& s) {
    const auto rounds = static_cast<double>(s.round_s.size());
    const auto of_rounds = [&](double count) { return percent(ratio(count, rounds)); };
    const auto spread = [](const std::vector<double>& times) {
        if (times.empty()) return std::string("none");
        return text("median ", fixed(at_share(times, 0.5), 0),
                    " s (10 to 90 %: ", fixed(at_share(times, 0.1), 0), " to ",
                    fixed(at_share(times, 0.9), 0), " s)");
    };
    const BalanceSums& sums = s.balance;
    std::string lines = headline(plan) + seats_and_rounds(s) + "used in  ";
    for (std::size_t source = 0; source < magic_sources; ++source)
        lines += text(source > 0 ? ", " : "", magic_names[source], " ", of_rounds(sums.rounds_with[source]));
    lines += text(" of rounds\nmagic    ", percent(ratio(sums.magic_kills, sums.kills)), " of ", sums.kills,
                  " kills\n", kill_shares(s), "first    kill of a round: ", spread(s.first_kill_s), "; in ",
                  of_rounds(rounds - static_cast<double>(s.first_kill_s.size())),
                  " of rounds none\nbetween  kills of a round: ", spread(s.between_kills_s),
                  "\nlead     changes hands ", fixed(ratio(sums.lead_changes, rounds), 2),
                  " times a round\nended    by the Great Work ", of_rounds(sums.by_great_work),
                  ", for nobody ", of_rounds(sums.for_nobody), "\n");
    return lines;
}

const std::string& bot_of(const Plan& plan, std::int32_t bot) {
    return plan.bots[static_cast<std::size_t>(bot)];
}

std::string table(const Plan& plan, const LeagueSummary& s) {
    std::string lines = headline(plan);
    for (const auto& p : s.pairs) {
        lines += text(bot_of(plan, p.high), " against ", bot_of(plan, p.low), "   won ", p.high_wins,
                      ", lost ", p.low_wins, ", drew ", p.matches - p.high_wins - p.low_wins, ": ",
                      percent(p.high_share()), "\n");
    }
    for (const auto& l : s.bots) {
        lines += text(bot_of(plan, l.bot), "   ", l.kills, " kills, ", l.deaths, " deaths, ",
                      percent(ratio(l.falls, l.deaths)), " of them falls, ", percent(ratio(l.hits, l.shots)),
                      " of ", l.shots, " shots hit, dry for ",
                      percent(ratio(seconds(l.dry), seconds(l.alive))), " of its life\n");
    }
    return lines + seats_and_rounds(s) + kill_shares(s);
}

Json json_of(const Plan& plan, const LeaguePair& p) {
    return {{"low", bot_of(plan, p.low)},  {"high", bot_of(plan, p.high)},
            {"matches", p.matches},        {"low_wins", p.low_wins},
            {"high_wins", p.high_wins},    {"draws", p.matches - p.low_wins - p.high_wins},
            {"high_share", p.high_share()}};
}

Json json_of(const Plan& plan, const LeagueBot& l) {
    return {{"bot", bot_of(plan, l.bot)},
            {"shots", l.shots},
            {"hits", l.hits},
            {"kills", l.kills},
            {"deaths", l.deaths},
            {"falls", l.falls},
            {"dry_share", ratio(seconds(l.dry), seconds(l.alive))}};
}

Json json_of(const BalanceSums& sums, const LeagueSummary& s) {
    auto used = Json::object();
    for (std::size_t source = 0; source < magic_sources; ++source)
        used.set(magic_names[source], sums.rounds_with[source]);
    return {{"rounds_with", used},
            {"kills", sums.kills},
            {"magic_kills", sums.magic_kills},
            {"lead_changes", sums.lead_changes},
            {"rounds_by_great_work", sums.by_great_work},
            {"rounds_for_nobody", sums.for_nobody},
            {"rounds_without_kill", s.round_s.size() - s.first_kill_s.size()},
            {"median_first_kill_s", at_share(s.first_kill_s, 0.5)},
            {"median_between_kills_s", at_share(s.between_kills_s, 0.5)}};
}

Json json_of(const Plan& plan, const LeagueSummary& s) {
    auto pairs = Json::array(), bots = Json::array();
    for (const auto& p : s.pairs) pairs.push_back(json_of(plan, p));
    for (const auto& l : s.bots) bots.push_back(json_of(plan, l));
    auto kills = Json::object();
    for (std::size_t cause = 0; cause < causes().size(); ++cause)
        if (!causes()[cause].empty()) kills.set(causes()[cause], s.kills[cause]);
    kills.set("own", s.own_deaths);
    return {{"league",
             {{"rules", plan.choice.rules},
              {"match", plan.choice.match},
              {"arena", plan.choice.arena},
              {"seed", plan.seed}}},
            {"pairs", pairs},
            {"bots", bots},
            {"seats", {{"player_1_wins", s.seat_wins[0]}, {"player_2_wins", s.seat_wins[1]}}},
            {"rounds",
             {{"count", s.round_s.size()},
              {"median_s", s.median_round_s()},
              {"p10_s", at_share(s.round_s, 0.1)},
              {"p90_s", at_share(s.round_s, 0.9)},
              {"time_out_share", time_out_share(s)}}},
            {"kills", kills},
            {"balance", json_of(s.balance, s)}};
}

/// Faults of the results in words; empty: none.
std::string complaint(const Plan& plan, const LeagueSummary& s) {
    std::string words;
    for (const auto& p : s.pairs) {
        if (p.high == p.low + 1 && (p.high_share() < 0.6 || p.high_share() > 0.85))
            words += text(bot_of(plan, p.high), " wins ", percent(p.high_share()), " against ",
                          bot_of(plan, p.low), ", not 60 to 85 %; ");
    }
    const double median = s.median_round_s();
    if (median < 100 || median > 240)
        words += text("the median round takes ", fixed(median, 0), " s, not 100 to 240; ");
    if (!words.empty()) words.resize(words.size() - 2);
    return words;
}

int run_league(const std::vector<std::string>& words) {
    const auto plan = read_plan(words);
    if (!plan) return refuse(plan.error());
    auto loaded = load_match_data(find_assets(), plan->choice);
    if (!loaded) return refuse(loaded.error());
    const bool to_file = !plan->json.empty() && plan->json != "-";
    if (const auto free = to_file ? check_output(plan->json) : Expected<void>(); !free)
        return refuse(free.error());
    const auto matches = play(*plan, std::make_shared<const MatchData>(std::move(*loaded)));
    if (!matches) return refuse(matches.error());
    const auto summary = summarise(*matches);
    const auto json = dump(json_of(*plan, summary), 1) + "\n";
    const auto words_for_people = plan->balance ? balance_table(*plan, summary) : table(*plan, summary);
    std::printf("%s", plan->json == "-" ? json.c_str() : words_for_people.c_str());
    if (to_file) {
        if (const auto written = write_text_file(plan->json, json); !written) return refuse(written.error());
    }
    const auto wrong = plan->check ? complaint(*plan, summary) : std::string();
    if (wrong.empty()) return done;
    tell_user(text("thaum: ", wrong));
    return does_not_hold;
}

const CommandRegistration registration_of_league({.name = "league", .help = league_help, .run = run_league});

}  // namespace

}  // namespace thaum::game::inline app
