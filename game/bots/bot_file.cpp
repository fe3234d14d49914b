#include "game/bots/bot_file.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/file.h"
#include "core/one_line.h"
#include "core/text.h"
#include "core/utf8.h"
#include "game/data/file_names.h"
#include "game/data/match_data.h"

namespace thaum::game::inline bots {

namespace {

constexpr Range distances{0, 100};  ///< allowed distances in a bot's file (m)

}  // namespace

BotSkill read_marksmanship(const ConfigTable& table) {
    BotSkill skill;
    skill.reaction = ticks(table.number("reaction_s", {0, 0.9}));
    skill.aim_error = table.number("aim_error_deg", {0, 90}) * radians_per_degree;
    skill.turn_speed = table.number("turn_deg_per_s", {1, 3600}) * radians_per_degree;
    skill.view_cos = det::cos(table.number("view_deg", {1, 360}) / 2 * radians_per_degree);
    skill.burst = ticks(table.number("burst_s", {0.01, 60}));
    skill.rest = ticks(table.number("rest_s", {0, 60}));
    skill.range = table.number("range_m", distances);
    return skill;
}

namespace {

LiftSkill read_lifting(const ConfigTable& table) {
    LiftSkill lift;
    lift.share = table.number("share", {0, 1});
    lift.seek = table.number("seek_m", distances);
    lift.largest = table.number("largest_m", distances);
    lift.lead = table.number("lead", {0, 2});
    lift.within = table.number("within_deg", {0.1, 90}) * radians_per_degree;
    lift.hold = ticks(table.number("hold_s", {0, 60}));
    lift.rest = ticks(table.number("rest_s", {0, 60}));
    lift.guards = table.boolean("guards", false) ? 1 : 0;
    return lift;
}

StirSkill read_stirring(const ConfigTable& table) {
    return {.share = table.number("share", {0, 1}),
            .seek = table.number("seek_m", distances),
            .hold = ticks(table.number("hold_s", {0.1, 60})),
            .rest = ticks(table.number("rest_s", {0, 600})),
            .brew = table.number("brew", {0, 1}, 0)};
}

CastSkill read_casting(const ConfigTable& table) {
    return {.share = table.number("share", {0, 1}),
            .force = table.number("force_n", {0.1, 10}),
            .jitter = table.number("jitter", {0, 1}),
            .harsh = table.number("harsh", {0, 1})};
}

EdgeSkill read_edge(const ConfigTable& table) {
    return {.panic = table.number("panic_below_hp", {0, 1000}), .heedless = table.number("heedless", {0, 1})};
}

/// Reads the whole skill of a bot from its file, with the values of its base.
BotSkill read_skill(const ConfigTable& root) {
    const Range share{0, 1}, health{0, 1000};
    BotSkill skill = read_marksmanship(root);
    skill.level = static_cast<std::uint32_t>(root.integer("level", {0, 99}));
    skill.keep = root.number("keep_m", distances);
    skill.lead = root.number("lead", {0, 2});
    skill.strafe = root.number("strafe", share);
    skill.strafe_step = ticks(root.number("strafe_step_s", {0.05, 10}));
    skill.dodges = root.boolean("dodges", false) ? 1 : 0;
    skill.vial_below = root.number("vial_below_hp", health);
    skill.spark_below = root.number("spark_below", share);
    skill.reserve = root.number("reserve", share);
    skill.cover_below = root.number("cover_below_hp", health);
    skill.variety = root.number("variety", share);
    skill.charge = root.number("charge", share);
    skill.arcs = root.boolean("arcs", false) ? 1 : 0;
    if (skill.arcs != 0) {
        skill.throws = root.number("throws", share);
        skill.over_cover = root.number("over_cover_per_s", {0, 100}) * gameplay_dt;
    } else if (root.has("base")) {
        // The base may throw, and then its numbers are here too.
        (void)root.number("throws", share, 0);
        (void)root.number("over_cover_per_s", {0, 100}, 0);
    }
    if (root.has("lift")) skill.lift = read_lifting(root.table("lift"));
    if (root.has("stir")) skill.stir = read_stirring(root.table("stir"));
    if (root.has("edge")) skill.edge = read_edge(root.table("edge"));
    if (root.has("cast")) skill.cast = read_casting(root.table("cast"));
    if (root.has("swing")) skill.swing_gain = root.table("swing").number("gain_m", {0.1, 100});
    return skill;
}

/// Texts of a bot's file for menu and screen.
void read_words(const ConfigTable& root, BotFile& bot) {
    bot.shown = root.string("name");
    if (const auto letters = decode_utf8(bot.shown).size(); letters < 1 || letters > longest_bot_name)
        root.report("name", text("'name' must be a text of 1 to ", longest_bot_name, " characters"));
    bot.style = bot_styles[root.choice("style", {bot_styles.begin(), bot_styles.end()})];
    bot.words = root.string("words");
    if (bot.words.empty() || bot.words.find('\n') != bot.words.npos)
        root.report("words", "'words' must be one line");
}

BotFile read_bot(const std::string& name, const ConfigTable& root) {
    BotFile bot;
    bot.name = name;
    read_words(root, bot);
    bot.skill = read_skill(root);
    return bot;
}

/// Fault of the key `base`, with its place; std::nullopt if the base can be read. `chain`: the bots from the
/// chosen one to that of this file, each based on the next.
std::optional<Error> fault_of_base(const std::filesystem::path& assets, const ConfigTable& root,
                                   const std::string& base, const std::vector<std::string>& chain) {
    const auto told = [&](std::string_view what) {
        return Error{text(root.place("base"), ": 'base' is '", base, "'", what)};
    };
    if (std::find(chain.begin(), chain.end(), base) != chain.end())
        return told(text(", which is based on '", chain.back(), "'"));
    std::error_code ignored;
    if (!plain_name(base) || !std::filesystem::exists(assets / text("bots/", base, ".toml"), ignored))
        return told(text(", but there is no bots/", printable(base, 64), ".toml",
                         near_file(base, assets / "bots", ".toml")));
    if (chain.size() > most_bases)
        return told(text(": '", chain.front(), "' has more than ", most_bases, " bases"));
    return std::nullopt;
}

/// Opens a bot's file and adds the values of its bases. A base is read and checked by itself, so that its
/// faults are told with the name and the lines of its own file. `chain`: the bots that are based on this one.
Expected<Config> open_with_bases(const std::filesystem::path& assets, const std::string& name,
                                 std::vector<std::string> chain) {
    auto file = read_data_file(assets, text("bots/", name, ".toml"));
    if (!file || !file->root().has("base")) return file;
    const auto base = file->root().string("base");
    if (!file->is_sound()) return file;
    chain.push_back(name);
    if (auto fault = fault_of_base(assets, file->root(), base, chain)) return std::move(*fault);
    const auto inherited = open_with_bases(assets, base, chain);
    if (!inherited) return inherited.error();
    (void)read_bot(base, inherited->root());
    if (const auto checked = inherited->check(); !checked) return checked.error();
    file->inherit(*inherited);
    return file;
}

Expected<BotFile> load_named(const std::filesystem::path& assets, const std::string& name) {
    const auto file = open_with_bases(assets, name, {});
    if (!file) return file.error();
    auto bot = read_bot(name, file->root());
    if (const auto checked = file->check(); !checked) return checked.error();
    return bot;
}

}  // namespace

std::vector<ListedBot> list_bots(const std::filesystem::path& assets) {
    std::vector<ListedBot> all;
    for (const auto& name : stems_in(assets / "bots")) all.push_back({name, load_named(assets, name)});
    const auto level_of = [](const ListedBot& bot) {
        return bot.file ? bot.file->skill.level : std::numeric_limits<std::uint32_t>::max();
    };
    std::ranges::stable_sort(all, {}, level_of);
    return all;
}

Expected<std::string> bot_named(const std::filesystem::path& assets, std::string_view word) {
    const auto all = list_bots(assets);
    std::vector<std::string> names;
    for (const auto& bot : all) {
        if (bot.name == word) return bot.name;
        names.push_back(bot.name);
    }
    for (const auto& bot : all)
        if (bot.file && word == text(bot.file->skill.level)) return bot.name;
    auto unknown = check_name(names, word, "bot").error();
    // The word may be the level of a bot whose file cannot be read.
    const auto faulty = std::ranges::find_if(all, [](const ListedBot& bot) { return !bot.file; });
    if (faulty != all.end()) unknown.message += text("; ", faulty->file.error().message);
    return unknown;
}

Expected<std::string> strongest_bot(const std::filesystem::path& assets) {
    const auto all = list_bots(assets);
    const auto last = std::find_if(all.rbegin(), all.rend(), [](const ListedBot& b) { return !!b.file; });
    if (last != all.rend()) return last->name;
    if (!all.empty()) return all.front().file.error();
    return fail(text(shown_path(assets, "bots"), ": the folder has no bot, NAME.toml"));
}

Expected<BotFile> load_bot(const std::filesystem::path& assets, std::string_view word) {
    const auto name = bot_named(assets, word);
    if (!name) return name.error();
    return load_named(assets, *name);
}

Expected<BotSkill> load_bot_skill(const std::filesystem::path& assets, std::string_view word) {
    const auto bot = load_bot(assets, word);
    if (!bot) return bot.error();
    return bot->skill;
}

}  // namespace thaum::game::inline bots
