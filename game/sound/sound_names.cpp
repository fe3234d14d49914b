#include "game/sound/sound_names.h"

#include "core/text.h"

namespace thaum::game {
namespace {

/// Finds sounds, and keeps the first error.
class Finder {
public:
    explicit Finder(const audio::SoundBank& bank) : bank_(bank) {}

    SoundNumber find(std::string_view name, std::string_view whose) {
        if (name.empty()) return std::nullopt;
        const auto number = bank_.find(name);
        if (!number && !error)
            error = Error{
                text(whose, " names the sound '", name, "', but there is no assets/sounds/", name, ".toml")};
        return number;
    }

    std::optional<Error> error;

private:
    const audio::SoundBank& bank_;
};

void find_events(const EventRows& rows, Finder& finder, MatchSounds& out) {
    constexpr std::string_view kind_of_power_up = "{power_up}";
    out.events.resize(rows.size());
    for (std::size_t kind = 0; kind < rows.size(); ++kind) {
        const auto& name = rows[kind].sound;
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

Expected<MatchSounds> match_sounds(const audio::SoundBank& bank, const Presentation& shown) {
    auto cues = cue_sounds(bank);
    if (!cues) return tl::unexpected(cues.error());
    MatchSounds out{.cues = *cues, .events = {}, .power_ups = {}, .wands = {}};
    Finder finder(bank);
    find_events(shown.events, finder, out);
    for (const auto& wand : shown.wands) {
        const auto whose = text("assets/wands/", wand.name, ".toml");
        const auto& names = wand.sounds;
        out.wands.push_back({.fire = finder.find(names.fire, whose),
                             .burst = finder.find(names.burst, whose),
                             .take = finder.find(names.take, whose),
                             .ready = finder.find(names.ready, whose),
                             .hold = finder.find(names.hold, whose)});
    }
    if (finder.error) return tl::unexpected(*finder.error);
    return out;
}

}  // namespace thaum::game
