#include "game/sound/sound_names.h"

#include <algorithm>

#include "core/near_name.h"
#include "core/text.h"

namespace thaum::game {
namespace {

/// Finds sounds, and notes the missing ones.
class Finder {
public:
    explicit Finder(const audio::SoundBank& bank) : bank_(bank) {}

    /// Finds a sound that `place` names. The words of `place` are filled in if there is none.
    SoundNumber find(std::string_view name, MissingName place) {
        if (name.empty()) return std::nullopt;
        const auto number = bank_.find(name);
        if (number || is_faulty(name)) return number;
        place.words = text("there is no sound '", name, "', sounds/", name, ".toml",
                           did_you_mean(name, bank_.sounds, &audio::Sound::name));
        missing.push_back(std::move(place));
        return number;
    }

    std::vector<MissingName> missing{};

private:
    bool is_faulty(std::string_view name) const {
        return std::any_of(bank_.faulty.begin(), bank_.faulty.end(),
                           [&](const auto& faulty) { return faulty.name == name; });
    }

    const audio::SoundBank& bank_;
};

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
    Finder finder(bank);
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

}  // namespace thaum::game
