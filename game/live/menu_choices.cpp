#include "game/live/menu_choices.h"

#include <algorithm>

#include "core/config.h"
#include "core/file.h"
#include "core/text.h"
#include "game/bots/bot_file.h"
#include "game/data/file_names.h"
#include "game/data/mutator.h"
#include "game/data/rule_files.h"

namespace thaum::game::inline live {
namespace {

constexpr Tick longest_shown = ticks(24 * 3600.0);  ///< rules of a longer round are shown as "no time limit"

MenuContext::Named told(const std::string& name, const RoundRules& rules) {
    const auto rounds = rules.rounds > 1 ? text("best of ", rules.rounds, ", ") : std::string();
    const auto clock = rules.length < longest_shown ? clock_text(rules.length / ticks_per_second)
                                                    : std::string("no time limit");
    return {name, text(name, ": ", rounds, "first to ", rules.kills, ", ", clock)};
}

/// Menu entry of a file that cannot be chosen, with its fault.
MenuContext::Named broken(const std::string& name, const Error& error) {
    return {name, text(name, ": cannot be read"), error.message};
}

MenuContext::Named rules_of(const std::filesystem::path& assets, const std::string& name) {
    const auto config = read_data_file(assets, text("rules/", name, ".toml"));
    if (!config) return broken(name, config.error());
    const auto rules = read_round_rules(*config);
    if (const auto checked = config->check(); !checked) return broken(name, checked.error());
    return told(name, rules);
}

/// Name and label of an arena, or a fault that prevents them. A match reports all other faults of the file.
MenuContext::Named arena_of(const std::filesystem::path& assets, const std::string& name,
                            const std::vector<MenuContext::Named>& before) {
    const auto config = read_data_file(assets, text("arenas/", name, ".toml"));
    if (!config) return broken(name, config.error());
    const auto root = config->root();
    const auto label = root.string("name", "");
    if (label.empty())
        return broken(name, {text(root.place("name"), ": 'name' must be a text in quotes, not empty")});
    const auto same = std::ranges::find_if(
        before, [&](const auto& other) { return other.label == label && other.fault.empty(); });
    if (same != before.end())
        return broken(name,
                      {text(root.place("name"), ": 'name' is '", label, "', which is the name of arenas/",
                            same->name, ".toml; give it another one")});
    return {name, label};
}

std::vector<MenuContext::Named> all_arenas(const LivePlan& plan) {
    auto all = arena_choices(plan.assets);
    const auto& chosen = plan.data->choice.arena;
    const auto row = std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.name == chosen; });
    if (row == all.end()) all.push_back({chosen, plan.data->arena.name});
    return all;
}

std::vector<MenuContext::Named> all_rules(const LivePlan& plan) {
    std::vector<MenuContext::Named> all;
    for (const auto& name : match_lengths(plan.assets)) all.push_back(rules_of(plan.assets, name));
    const auto& chosen = plan.data->choice.match;
    // The rules of the command line are shown as changed by --set, whose values replace those of data files.
    const auto row = std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == chosen; });
    (row == all.end() ? all.emplace_back() : *row) = told(chosen, plan.data->round);
    return all;
}

std::vector<MenuContext::Named> all_mutators(const std::filesystem::path& assets) {
    std::vector<MenuContext::Named> all;
    for (const auto& [name, file] : list_mutators(assets)) {
        if (file)
            all.push_back({name, file->shown, {}, file->words});
        else
            all.push_back(broken(name, file.error()));
    }
    return all;
}

std::vector<MenuContext::Named> all_bots(const std::filesystem::path& assets) {
    std::vector<MenuContext::Named> all;
    for (const auto& [name, file] : list_bots(assets)) {
        if (file)
            all.push_back({name, file->shown, {}, text(capitalised(file->style), ". ", file->words)});
        else
            all.push_back(broken(name, file.error()));
    }
    // The list must not be empty. Without a bot only two players can begin.
    if (all.empty()) all.push_back({"", "none", strongest_bot(assets).error().message});
    return all;
}

}  // namespace

std::vector<MenuContext::Named> arena_choices(const std::filesystem::path& assets) {
    std::vector<MenuContext::Named> all;
    for (const auto& file : files_in(assets / "arenas", ".toml").value_or({}))
        all.push_back(arena_of(assets, file.stem().string(), all));
    return all;
}

std::size_t index_of(const std::vector<MenuContext::Named>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const auto& n) { return n.name == name; });
    return found == list.end() ? 0 : static_cast<std::size_t>(found - list.begin());
}

std::string label_of(const std::vector<MenuContext::Named>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const auto& n) { return n.name == name; });
    return found == list.end() ? name : found->label;
}

MenuContext find_menu_context(const LivePlan& plan) {
    MenuContext context{.bots = all_bots(plan.assets),
                        .rules = all_rules(plan),
                        .arenas = all_arenas(plan),
                        .mutators = all_mutators(plan.assets),
                        .first_start = plan.first_start,
                        .ends_match = plan.start_screen,
                        .start_fault = plan.start_fault};
    for (const auto& wand : plan.data->wands) context.wands.at(wand.stats.slot) = capitalised(wand.name);
    return context;
}

}  // namespace thaum::game::inline live
