#include "game/match/kind_tables.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/one_line.h"
#include "core/text.h"
#include "game/components/power_up.h"
#include "game/data/event_kinds.h"
#include "game/data/spell.h"

namespace thaum::game::inline match {
namespace {

using input::Kind;
using input::KindTable;

/// Appends a kind to the table, unless its number is not in use, so that it has no name.
void add(std::size_t number, std::string_view name, KindTable& table) {
    if (!name.empty()) table.kinds.push_back({static_cast<std::uint16_t>(number), std::string(name)});
}

const KindTable* table_of(const std::vector<KindTable>& tables, const std::string& group) {
    const auto found = std::find_if(tables.begin(), tables.end(),
                                    [&](const KindTable& table) { return table.group == group; });
    return found == tables.end() ? nullptr : &*found;
}

/// Name of a kind in quotes; "nothing" if the number is not in use.
std::string kind_in_words(const KindTable* table, std::uint16_t number) {
    const auto none = std::vector<Kind>();
    const auto& kinds = table != nullptr ? table->kinds : none;
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) { return kind.number == number; });
    return found == kinds.end() ? "nothing" : text("'", in_one_line(found->name), "'");
}

}  // namespace

std::vector<KindTable> kind_tables(const MatchData& data) {
    KindTable cause{"cause", {}}, event{"event", {}}, ingredient{"ingredient", {}}, potion{"potion", {}},
        power_up{"power_up", {}}, spell{"spell", {}}, wand{"wand", {}};
    const auto& all = event_kinds();
    for (std::size_t i = 0; i < all.causes.size(); ++i) add(i, all.causes[i], cause);
    for (std::size_t i = 0; i < all.kinds.size(); ++i) add(i, all.kinds[i].name, event);
    if (data.cauldron) {
        const auto& ingredients = data.cauldron->ingredients;
        for (std::size_t i = 0; i < ingredients.size(); ++i) add(i, ingredients[i].name, ingredient);
    }
    for (std::size_t i = 0; i < data.recipes.size(); ++i) add(i, data.recipes[i].name, potion);
    for (std::size_t i = 0; i < power_up_names.size(); ++i) add(i, power_up_names[i], power_up);
    for (std::size_t i = 0; i < data.spells.size(); ++i) add(i, data.spells[i].name, spell);
    for (const auto& loaded : data.wands) add(loaded.stats.slot + 1, loaded.name, wand);
    std::sort(wand.kinds.begin(), wand.kinds.end(),
              [](const Kind& a, const Kind& b) { return a.number < b.number; });
    std::vector<KindTable> tables{cause, event, ingredient};
    if (!potion.kinds.empty()) tables.push_back(potion);
    tables.push_back(power_up);
    if (!spell.kinds.empty()) tables.push_back(spell);
    tables.push_back(wand);
    return tables;
}

std::string kind_difference(const std::vector<KindTable>& recorded, const std::vector<KindTable>& here) {
    std::set<std::pair<std::string, std::uint16_t>> numbers;
    const auto add_all = [&](const KindTable& table) {
        for (const auto& kind : table.kinds) numbers.emplace(table.group, kind.number);
    };
    for (const auto& table : recorded) add_all(table);
    for (const auto& table : here)
        if (table.group == "event" || table.group == "cause") add_all(table);
    for (const auto& [group, number] : numbers) {
        const auto there = kind_in_words(table_of(recorded, group), number);
        const auto current = kind_in_words(table_of(here, group), number);
        if (there != current)
            return text(in_one_line(group), " ", number, " is ", there, " in the log and ", current,
                        " in this program: replay the log with the program that recorded it");
    }
    return {};
}

}  // namespace thaum::game::inline match
