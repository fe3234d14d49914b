#include <algorithm>

#include "game/match/hurt_side.h"
#include "game/senses/sound/scene_parts.h"

namespace thaum::game::inline senses {
namespace {

/// Harm that is heard at full strength (HP).
constexpr double loud_harm = 40;

/// Index of the wand whose shots have this kind of hit; the number of wands if there is none.
std::size_t wand_of_hit(const MatchData& data, EventKind hit) {
    const auto name = name_of(hit);
    for (std::size_t i = 0; i < data.wands.size(); ++i)
        for (const auto& kind : data.wands[i].kind->hits)
            if (kind.name == name) return i;
    return data.wands.size();
}

SoundNumber sound_of(const SoundWriting& writing, const Event& event) {
    const auto& sounds = writing.sounds;
    if (event.kind == EventKind::burst) {
        const auto wand = wand_of_hit(writing.match.data(), static_cast<EventKind>(event.detail));
        return wand < sounds.wands.size() ? sounds.wands[wand].burst : std::nullopt;
    }
    if (event.kind == EventKind::power_up && event.detail < sounds.power_ups.size())
        return sounds.power_ups.at(event.detail);
    const auto& rows = writing.match.data().presentation->events;
    if (row_of(rows, event.kind).sound == of_spell)
        return event.detail < sounds.spells.size() ? sounds.spells[event.detail] : std::nullopt;
    const auto kind = static_cast<std::size_t>(event.kind);
    return kind < sounds.events.size() ? sounds.events[kind] : std::nullopt;
}

/// Position of an event: its own or, if it has none, the position of the player to whom it happened.
vec3 place_of(const SoundWriting& writing, const Event& event) {
    const auto& info = info_of(event.kind);
    if (info.placed || event.subject >= players) return event.place;
    return writing.match.world().get<Motion>(wizard_of(writing.match.world(), event.subject)).position;
}

void tell_end_of_round(SoundWriting& writing) {
    const auto winner = writing.match.match().winner;
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto cue = winner == no_player ? Cue::round_drawn
                         : winner == player  ? Cue::round_won
                                             : Cue::round_lost;
        begin(writing, cue, {.heard_by = writing.ears_of(player), .at_ear = true});
    }
}

/// Starts the sound of an injury for the injured player: at the ear, since the sound's place is the
/// listener's own body. Its caption names the side from which the harm came, as the body feels it; a fall has
/// no side.
void begin_own_hurt(SoundWriting& writing, const Event& event, SoundNumber sound, double gain) {
    // Distance of a made-up sound source on the side from which the harm came (m). It only has to be larger
    // than the distance up to which a sound counts as the listener's own.
    constexpr double told_distance = 5;
    const auto& world = writing.match.world();
    const auto& rows = writing.match.data().presentation->events;
    Heard heard{.gain = gain, .heard_by = writing.ears_of(event.subject), .at_ear = true};
    const auto way = way_to_source(writing.match, event, event.subject);
    if (way && row_of(rows, event.kind).mark != HudMark::fall) {
        const vec3 flat(way->x, 0, way->z);
        const auto& motion = world.get<Motion>(wizard_of(world, event.subject));
        heard.sided = true;
        heard.place =
            eye_of(writing.match.data().wizard, motion.position) + told_distance * glm::normalize(flat);
    }
    begin(writing, sound, heard);
}

void add_sound_of(SoundWriting& writing, const Event& event) {
    if (event.kind == EventKind::round_end) return tell_end_of_round(writing);
    const auto& rows = writing.match.data().presentation->events;
    const bool own_affair = row_of(rows, event.kind).mark == HudMark::warning;
    const bool takes_health = !info_of(event.kind).cause.empty();
    if (takes_health || event.kind == EventKind::shot) writing.memory.fought_at = event.tick;
    Heard heard{.place = place_of(writing, event)};
    if (takes_health || event.kind == EventKind::held_off)
        heard.gain = 0.4 + 0.6 * std::min(1.0, event.amount / loud_harm);
    if (own_affair) {
        heard.heard_by = event.subject < players ? writing.ears_of(event.subject) : 0;
        heard.at_ear = true;
    }
    if (event.subject >= players && !info_of(event.kind).placed) heard.at_ear = true;
    const auto sound = sound_of(writing, event);
    if (strikes_body(event.kind) && event.subject < players) {
        // A wizard who fell may have been put back elsewhere, so the sound is played at the ear.
        begin_own_hurt(writing, event, sound, heard.gain);
        heard.heard_by &= ~writing.ears_of(event.subject);
    }
    begin(writing, sound, heard);
}

}  // namespace

void add_event_sounds(SoundWriting& writing) {
    writing.memory.follower.each_event(writing.match,
                                       [&](const Event& event) { add_sound_of(writing, event); });
}

}  // namespace thaum::game::inline senses
