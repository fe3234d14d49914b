#include "game/tactile/match_effects.h"

#include <utility>

#include "core/text.h"

namespace thaum::game {

namespace {

/// Finds the effects that spells name. The error names the effect that is missing.
Expected<std::vector<EffectNumber>> spell_effects(const tactile::EffectBank& bank,
                                                  const std::vector<SpellPresentation>& spells) {
    std::vector<EffectNumber> found;
    for (const auto& spell : spells) {
        found.push_back(spell.tactile.empty() ? std::nullopt : bank.find(spell.tactile));
        if (!spell.tactile.empty() && !found.back())
            return fail(text("assets/spells/", spell.name, ".toml names the effect '", spell.tactile,
                             "', but there is no assets/tactile/effects/", spell.tactile, ".toml"));
    }
    return found;
}

}  // namespace

Expected<MatchEffects> match_effects(const tactile::EffectBank& bank, const Presentation& shown) {
    MatchEffects out;
    out.events.resize(shown.events.size());
    for (std::size_t kind = 0; kind < shown.events.size(); ++kind) {
        const auto& name = shown.events[kind].tactile;
        if (name.empty() || name == of_spell) continue;
        out.events[kind] = bank.find(name);
        if (!out.events[kind])
            return fail(text("event '", name_of(static_cast<EventKind>(kind)), "' names the effect '", name,
                             "', but there is no assets/tactile/effects/", name, ".toml"));
    }
    auto spells = spell_effects(bank, shown.spells);
    if (!spells) return spells.error();
    out.spells = std::move(*spells);
    const std::pair<std::string_view, std::uint32_t*> needed[] = {
        {"recoil", &out.recoil},       {"stir", &out.stir},
        {"heartbeat", &out.heartbeat}, {"great_work", &out.great_work},
        {"walk_left", &out.walk_left}, {"walk_right", &out.walk_right},
        {"sound_low", &out.sounds[0]}, {"sound_middle", &out.sounds[1]},
        {"sound_high", &out.sounds[2]}};
    for (const auto& [name, number] : needed) {
        const auto found = bank.find(name);
        if (!found)
            return fail(text("assets/tactile/effects has no '", name, ".toml', which the match needs"));
        *number = *found;
    }
    return out;
}

}  // namespace thaum::game
