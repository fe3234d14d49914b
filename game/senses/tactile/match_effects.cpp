#include "game/senses/tactile/match_effects.h"

#include <utility>

#include "core/text.h"
#include "game/data/name_finder.h"

namespace thaum::game::inline senses {

MatchEffects match_effects(const tactile::EffectBank& bank, const Presentation& shown) {
    MatchEffects out;
    NameFinder finder(bank, bank.effects, "effect", "tactile/effects");
    out.events.resize(shown.events.size());
    for (std::size_t kind = 0; kind < shown.events.size(); ++kind) {
        const auto& name = shown.events[kind].tactile;
        const auto event = static_cast<EventKind>(kind);
        if (name != of_spell)
            out.events[kind] =
                finder.find(name, {file_of_event(event), table_of_event(event), "tactile", ""});
    }
    for (const auto& spell : shown.spells)
        out.spells.push_back(
            finder.find(spell.tactile, {text("spells/", spell.name, ".toml"), "event", "tactile", ""}));
    const std::pair<std::string_view, EffectNumber*> needed[] = {
        {"recoil", &out.recoil},       {"stir", &out.stir},
        {"heartbeat", &out.heartbeat}, {"great_work", &out.great_work},
        {"walk_left", &out.walk_left}, {"walk_right", &out.walk_right},
        {"sound_low", &out.sounds[0]}, {"sound_middle", &out.sounds[1]},
        {"sound_high", &out.sounds[2]}};
    for (const auto& [name, number] : needed) *number = finder.find(name, {});
    out.missing = std::move(finder.missing);
    return out;
}

}  // namespace thaum::game::inline senses
