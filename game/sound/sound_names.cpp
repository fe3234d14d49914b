#include "game/sound/sound_names.h"

#include <algorithm>

#include "core/text.h"

namespace thaum::game {
namespace {

/// Finds sounds, and notes the missing ones.
class Finder {
public:
    explicit Finder(const audio::SoundBank& bank) : bank_(bank) {}

    SoundNumber find(std::string_view name, std::string_view whose) {
        if (name.empty()) return std::nullopt;
        const auto number = bank_.find(name);
        if (!number && !is_faulty(name))
            missing.push_back(
                text(whose, " names the sound '", name, "', but there is no assets/sounds/", name, ".toml"));
        return number;
    }

    std::vector<std::string> missing{};

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
        const auto whose = text("event '", name_of(static_cast<EventKind>(kind)), "'");
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
    for (std::size_t i = 0; i < cues; ++i) out.cues.at(i) = finder.find(cue_names.at(i), "the match");
    find_events(shown.events, finder, out);
    for (const auto& spell : shown.spells)
        out.spells.push_back(finder.find(spell.sound, text("assets/spells/", spell.name, ".toml")));
    for (const auto& wand : shown.wands) {
        const auto whose = text("assets/wands/", wand.name, ".toml");
        const auto& names = wand.sounds;
        out.wands.push_back({.fire = finder.find(names.fire, whose),
                             .burst = finder.find(names.burst, whose),
                             .take = finder.find(names.take, whose),
                             .ready = finder.find(names.ready, whose),
                             .hold = finder.find(names.hold, whose)});
    }
    out.missing = std::move(finder.missing);
    return out;
}

}  // namespace thaum::game
