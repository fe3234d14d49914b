// Menu page: the mutators of the next match, each of which is on or off.
#include <algorithm>

#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

bool is_on(const MenuState& s, const std::string& name) {
    return std::ranges::find(s.mutators, name) != s.mutators.end();
}

/// Turns a mutator on or off. All that are on are kept in the settings, in the order of the page.
void turn_mutator(const RowPress& press, int) {
    auto& s = press.state;
    const auto& turned = press.context.mutators[press.row.index];
    std::vector<std::string> on;
    for (const auto& one : press.context.mutators)
        if (is_on(s, one.name) != (one.name == turned.name)) on.push_back(one.name);
    if (!turned.fault.empty()) std::erase(on, turned.name);
    s.mutators = s.settings.last.mutators = std::move(on);
}

void add_mutator_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    for (std::size_t i = 0; i < context.mutators.size(); ++i) {
        const auto& one = context.mutators[i];
        rows.push_back({.look = {.label = one.label,
                                 .help = one.fault.empty() ? one.words : one.fault,
                                 .value = is_on(s, one.name) ? "on" : "off",
                                 .longest_value = "off",
                                 .adjustable = true,
                                 .dim = !one.fault.empty()},
                        .turn = turn_mutator,
                        .index = i});
    }
}

std::string reset_mutators(MenuState& s) {
    s.mutators.clear();
    s.settings.last.mutators.clear();
    return "mutators";
}

const PageRegistration mutators_page{{
    .name = "mutators",
    .title = [](const MenuState&, const MenuContext&) { return std::string("Mutators"); },
    .add_rows = add_mutator_rows,
    .reset = reset_mutators,
}};

}  // namespace
}  // namespace thaum::game::inline menu
