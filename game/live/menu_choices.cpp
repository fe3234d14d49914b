#include "game/live/menu_choices.h"

#include <algorithm>

#include "core/config.h"
#include "core/file.h"
#include "core/text.h"
#include "game/bots/bot.h"
#include "game/hud/event_words.h"

namespace thaum::app {
namespace {

constexpr std::size_t max_data_file = 1U << 20U;
constexpr Tick longest_shown = ticks(24 * 3600.0);  ///< rules of a longer round mean no limit

MenuContext::Named told(const std::string& name, const game::RoundRules& rules) {
    const auto rounds = rules.rounds > 1 ? text("best of ", rules.rounds, ", ") : std::string();
    const auto clock = rules.length < longest_shown ? clock_text(rules.length / ticks_per_second)
                                                    : std::string("no time limit");
    return {name, text(name, ": ", rounds, "first to ", rules.kills, ", ", clock)};
}

std::optional<MenuContext::Named> rules_of(const std::filesystem::path& file) {
    const auto source = read_text_file(file, max_data_file);
    if (!source) return {};
    const auto config = Config::parse(*source, file.string(), 1);
    if (!config) return {};
    const auto rules = game::read_round_rules(*config);
    if (!config->check()) return {};
    return told(file.stem().string(), rules);
}

/// Name and label of an arena; std::nullopt if the file has none. A match reports all other faults.
std::optional<MenuContext::Named> arena_of(const std::filesystem::path& file) {
    const auto source = read_text_file(file, max_data_file);
    if (!source) return {};
    const auto config = Config::parse(*source, file.string(), 1);
    if (!config) return {};
    auto label = config->root().string("name", "");
    if (label.empty()) return {};
    return MenuContext::Named{file.stem().string(), std::move(label)};
}

/// All files of a data folder that `read` accepts, sorted by name.
template <class Read>
std::vector<MenuContext::Named> all_in(const std::filesystem::path& folder, Read read) {
    std::vector<MenuContext::Named> all;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->path().extension() != ".toml") continue;
        if (auto one = read(it->path())) all.push_back(std::move(*one));
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return all;
}

std::vector<MenuContext::Named> all_arenas(const LivePlan& plan) {
    auto all = all_in(plan.assets / "arenas", arena_of);
    const auto& chosen = plan.data->choice.arena;
    const auto row = std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.name == chosen; });
    if (row == all.end()) all.push_back({chosen, plan.data->arena.name});
    return all;
}

std::vector<MenuContext::Named> all_rules(const LivePlan& plan) {
    auto all = all_in(plan.assets / "rules", rules_of);
    const auto& chosen = plan.data->choice.match;
    // Rules that were chosen on the command line, with the changes of --set.
    const auto row = std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == chosen; });
    (row == all.end() ? all.emplace_back() : *row) = told(chosen, plan.data->round);
    return all;
}

}  // namespace

std::size_t index_of(const std::vector<MenuContext::Named>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const auto& n) { return n.name == name; });
    return found == list.end() ? 0 : static_cast<std::size_t>(found - list.begin());
}

MenuContext find_menu_context(const LivePlan& plan) {
    MenuContext context{.rules = all_rules(plan),
                        .arenas = all_arenas(plan),
                        .first_start = plan.first_start,
                        .ends_match = plan.start_screen,
                        .settings_fault = plan.settings_fault};
    for (const auto& wand : plan.data->wands)
        context.wands.at(wand.stats.slot) = game::capitalised(wand.kind->name);
    for (int level = game::easiest_bot; level <= game::hardest_bot; ++level) {
        if (game::load_bot_skill(plan.assets, level)) context.levels.push_back(level);
    }
    // The easiest stands in; the match will report the missing file.
    if (context.levels.empty()) context.levels.push_back(game::easiest_bot);
    return context;
}

}  // namespace thaum::app
