#include "game/tactile/match_effects.h"

#include <algorithm>
#include <utility>

#include "core/near_name.h"
#include "core/text.h"

namespace thaum::game {
namespace {

/// Finds effects, and notes the missing ones.
class Finder {
public:
    explicit Finder(const tactile::EffectBank& bank) : bank_(bank) {}

    /// Finds an effect that `place` names. The words of `place` are filled in if there is none.
    EffectNumber find(std::string_view name, MissingName place) {
        if (name.empty()) return std::nullopt;
        const auto number = bank_.find(name);
        if (number || is_faulty(name)) return number;
        place.words = text("there is no effect '", name, "', tactile/effects/", name, ".toml",
                           did_you_mean(name, bank_.effects, &tactile::Effect::name));
        missing.push_back(std::move(place));
        return number;
    }

    std::vector<MissingName> missing{};

private:
    bool is_faulty(std::string_view name) const {
        return std::ranges::any_of(bank_.faulty, [&](const LeftOut& faulty) { return faulty.name == name; });
    }

    const tactile::EffectBank& bank_;
};

}  // namespace

MatchEffects match_effects(const tactile::EffectBank& bank, const Presentation& shown) {
    MatchEffects out;
    Finder finder(bank);
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

}  // namespace thaum::game
