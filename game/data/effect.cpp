#include "game/data/effect.h"

#include <algorithm>

#include "core/text.h"
#include "game/data/match_data.h"

namespace thaum::game::inline data {
namespace {

/// Numbers the effects of one list and appends them to those of the match.
void number_list(MatchData& data, EffectList& list, std::string_view giver,
                 std::uint32_t potion = no_potion) {
    for (auto& one : list) {
        one.number = static_cast<std::uint32_t>(data.effects.size());
        one.potion = potion;
        one.giver = giver;
        data.effects.push_back(one);
    }
}

}  // namespace

double strengthened(double factor, double strength) {
    return strength == 1 ? factor : std::max(0.0, 1 + (factor - 1) * strength);
}

EffectList read_effects(const ConfigTable& holder) {
    const auto& kinds = effect_kinds();
    std::vector<std::string_view> names;
    for (const auto& kind : kinds) names.push_back(kind.name);
    EffectList list;
    for (const auto& entry : holder.tables("effect")) {
        const auto kind = entry.choice("kind", names);
        if (kind >= kinds.size()) continue;
        list.push_back({.kind = &kinds[kind],
                        .rules = kinds[kind].read(entry),
                        .lasts = kinds[kind].lasts ? ticks(entry.number("lasts_s", {0.01, 3600})) : Tick{0}});
    }
    return list;
}

Expected<void> number_effects(MatchData& data) {
    data.effects.clear();
    for (std::uint32_t i = 0; i < data.recipes.size(); ++i)
        number_list(data, data.recipes[i].effects, data.recipes[i].name, i);
    for (auto& spell : data.spells) number_list(data, spell.effects, spell.name);
    for (std::size_t i = 0; i < power_up_names.size(); ++i)
        number_list(data, data.rules.power_ups[i].effects, power_up_names[i]);
    if (data.orb) number_list(data, data.orb->effects, "orb");
    if (data.crystal) number_list(data, data.crystal->effects, "crystal");
    if (data.effects.size() > max_effects)
        return fail(
            text("the data files list ", data.effects.size(), " effects; a match has at most ", max_effects));
    return {};
}

bool is_worth_taking(const EffectList& list) {
    return std::ranges::any_of(
        list, [](const ListedEffect& one) { return one.lasts > 0 || one.kind->worth_taking; });
}

bool has_kind(const EffectList& list, std::string_view kind) {
    return std::ranges::any_of(list, [&](const ListedEffect& one) { return one.kind->name == kind; });
}

Tick longest_of(const EffectList& list) {
    Tick longest = 0;
    for (const auto& one : list) longest = std::max(longest, one.lasts);
    return longest;
}

Tick end_of(const EffectList& list, const Effects& effects) {
    Tick end = 0;
    for (const auto& one : list) end = std::max(end, effects.until[one.number]);
    return end;
}

Factors factors_of(std::span<const ListedEffect> all, const Effects* effects, Tick tick) {
    Factors product;
    if (effects == nullptr) return product;
    for (const auto& one : all)
        if (tick < effects->until[one.number]) product *= one.rules->factors(effects->strength[one.number]);
    return product;
}

}  // namespace thaum::game::inline data
