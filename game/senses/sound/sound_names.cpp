#include "game/senses/sound/sound_names.h"

#include <utility>

#include "core/text.h"
#include "game/data/name_finder.h"

namespace thaum::game::inline senses {
namespace {

using Finder = NameFinder<audio::SoundBank, audio::Sound>;

void find_events(const EventRows& rows, Finder& finder, MatchSounds& out) {
    constexpr std::string_view kind_of_power_up = "{power_up}";
    out.events.resize(rows.size());
    for (std::size_t kind = 0; kind < rows.size(); ++kind) {
        const auto& name = rows[kind].sound;
        if (name == of_spell) continue;
        const auto event = static_cast<EventKind>(kind);
        const MissingName whose{file_of_event(event), table_of_event(event), "sound", ""};
        const auto at = name.find(kind_of_power_up);
        if (at == std::string::npos) {
            out.events[kind] = finder.find(name, whose);
            continue;
        }
        for (std::size_t i = 0; i < power_up_names.size(); ++i) {
            auto one = name;
            one.replace(at, kind_of_power_up.size(), power_up_names.at(i));
            out.power_ups.at(i) = finder.find(one, whose);
        }
    }
}

}  // namespace

MatchSounds match_sounds(const audio::SoundBank& bank, const Presentation& shown) {
    MatchSounds out;
    Finder finder(bank, bank.sounds, "sound", "sounds");
    for (std::size_t i = 0; i < cues; ++i) out.cues.at(i) = finder.find(cue_names.at(i), {});
    find_events(shown.events, finder, out);
    for (const auto& spell : shown.spells)
        out.spells.push_back(
            finder.find(spell.sound, {text("spells/", spell.name, ".toml"), "event", "sound", ""}));
    for (const auto& wand : shown.wands) {
        const auto find = [&](const std::string& name, std::string key) {
            return finder.find(name, {text("wands/", wand.name, ".toml"), "sound", std::move(key), ""});
        };
        const auto& names = wand.sounds;
        out.wands.push_back({.fire = find(names.fire, "fire"),
                             .burst = find(names.burst, "burst"),
                             .take = find(names.take, "take"),
                             .ready = find(names.ready, "ready"),
                             .hold = find(names.hold, "hold")});
    }
    out.missing = std::move(finder.missing);
    return out;
}

}  // namespace thaum::game::inline senses
