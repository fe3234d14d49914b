#include "game/picture/casting_picture.h"

#include <algorithm>

#include "core/text.h"
#include "game/components/casting.h"
#include "game/components/orb.h"
#include "game/components/station.h"
#include "game/data/presentation.h"
#include "game/data/reading.h"
#include "game/match/simulation.h"
#include "game/stations/cauldron/ladle.h"

namespace thaum::game::inline picture {
namespace {

void take_points(const DrawnStroke& stroke, StrokePicture& out) {
    out.count = stroke.count;
    out.apart_s = stroke.every * gameplay_dt;
    std::copy_n(stroke.points.begin(), stroke.count, out.points.begin());
    out.force_now = out.count > 0 ? static_cast<double>(out.points[out.count - 1].force) : 0;
    out.force_mean = mean_force_of(stroke);
}

/// Finds the points on the brew's surface where the ladle, which the hand moves, drew the stroke.
void find_places(const Simulation& match, ecs::Entity wizard, StrokePicture& out) {
    const auto& rules = match.data().cauldron;
    if (!out.on_brew || !match.world().has<Ladle>(wizard) || !rules) {
        if (out.on_brew) out.count = 0;
        return;
    }
    const auto frame =
        ladle_frame(*rules, match.world().single<Cauldron>(), match.world().get<AtStation>(wizard).yaw);
    for (std::uint32_t i = 0; i < out.count; ++i) {
        const auto& p = out.points[i];
        out.places[i] = fvec3(frame.to_world({p.x, p.z, -p.y}));
    }
}

/// Replaces the force of the stroke by that of a key chord (a wand's key while the button Trace is held), if
/// one was pressed during the stroke.
void take_chord(const Simulation& match, ecs::Entity wizard, const DrawnStroke& drawn, StrokePicture& out) {
    const auto* last = match.world().find<LastReading>(wizard);
    out.chord = drawn.over == by_chord && last != nullptr && last->at != 0;
    if (out.chord) out.force_now = out.force_mean = last->force;
}

void take_stroke(const Simulation& match, ecs::Entity wizard, std::uint32_t player, StrokePicture& out) {
    out.count = 0;
    out.drawing = false;
    const auto played = match.match().played;
    const auto* drawn = match.world().find<DrawnStroke>(wizard);
    const auto& ended = match.context().output.strokes.read()[player];
    if (drawn != nullptr) {
        out.drawing = true;
        out.read = false;
        out.since_end_s = 0;
    } else if (ended.at != 0 && played >= ended.at && seconds(played - ended.at) < stroke_fade_seconds) {
        drawn = &ended.stroke;
        out.read = ended.read;
        out.since_end_s = seconds(played - ended.at);
    }
    out.curve = match.world().has<Scrying>(wizard);
    if (drawn == nullptr || out.curve) return;
    out.on_brew = drawn->on_brew != 0;
    take_points(*drawn, out);
    take_chord(match, wizard, *drawn, out);
    find_places(match, wizard, out);
}

std::optional<StrokeOutcome> outcome_of(EventKind kind) {
    switch (kind) {
        case EventKind::cast: return StrokeOutcome::cast;
        case EventKind::unread: return StrokeOutcome::unread;
        case EventKind::unfocused: return StrokeOutcome::unfocused;
        case EventKind::fizzled: return StrokeOutcome::fizzled;
        default: return std::nullopt;
    }
}

void take_reading(const Simulation& match, ecs::Entity wizard, std::uint32_t player, ReadingPicture& out) {
    out = {};
    const auto* last = match.world().find<LastReading>(wizard);
    const auto played = match.match().played;
    if (last == nullptr || last->at == 0 || played < last->at) return;
    out.age_s = seconds(played - last->at);
    out.gesture = last->gesture;
    out.nearest = last->nearest;
    out.probability = last->probability;
    out.force = last->force;
    out.turns = last->turns;
    const auto& ended = match.context().output.strokes.read()[player];
    if (ended.chord_at == last->at) out.chord = ended.chord_slot;
    if (out.age_s > reading_seconds) return;
    const auto& events = match.events();
    for (auto i = events.count(); i > events.first() && events[i - 1].tick + 1 >= last->at; --i) {
        const auto& event = events[i - 1];
        const auto outcome = outcome_of(event.kind);
        if (!outcome || event.by != player || std::max<Tick>(event.tick, 1) != last->at) continue;
        out.outcome = *outcome;
        out.event = event;
        if (*outcome == StrokeOutcome::fizzled) out.refusal = ended.refusal;
        return;
    }
}

/// Copies a stroke that was too small or too quick to be read. Nothing is copied if the stroke was ended by a
/// key chord (a wand's key while the button Trace is held), or by the ladle coming or going.
void take_slip(const Simulation& match, std::uint32_t player, CastingPicture& out) {
    out.slip = Slip::none;
    out.slip_age_s = 1e6;
    const auto& ended = match.context().output.strokes.read()[player];
    const auto played = match.match().played;
    if (ended.at == 0 || played < ended.at || ended.stroke.over != 0) return;
    if (match.context().input.strokes_unread[player]) return;
    out.slip_age_s = seconds(played - ended.at);
    if (out.slip_age_s <= reading_seconds) out.slip = slip_of(*match.data().casting, ended.stroke);
}

/// Copies how the effect of a spell that was cast earlier has ended, such as a recalled thing that fell.
void take_outcome(const Simulation& match, std::uint32_t player, CastingPicture& out) {
    out.outcome.clear();
    out.outcome_age_s = 1e6;
    const auto& ended = match.context().output.strokes.read()[player];
    const auto played = match.match().played;
    if (ended.outcome_at == 0 || played < ended.outcome_at) return;
    out.outcome_age_s = seconds(played - ended.outcome_at);
    if (out.outcome_age_s <= reading_seconds) out.outcome = ended.outcome;
}

/// Copies the path of a hand that may cast spells without a button, and the gesture that last almost cast
/// one.
void take_free(const Simulation& match, ecs::Entity wizard, FreePicture& out) {
    constexpr std::uint32_t shown = 125;  // number of newest points that are shown: those of one second
    out.count = 0;
    out.miss_age_s = 1e6;
    const auto& world = match.world();
    const auto* miss = world.find<NearMiss>(wizard);
    const auto played = match.match().played;
    if (miss != nullptr && miss->at != 0 && played >= miss->at) {
        out.miss = *miss;
        out.miss_age_s = seconds(played - miss->at);
    }
    const auto* hand = world.find<FreeHand>(wizard);
    if (hand == nullptr || hand->count == 0) return;
    const auto points = std::min(hand->count, shown);
    out.count = std::min<std::uint32_t>(points, FreePicture::max_points);
    for (std::uint32_t i = 0; i < out.count; ++i) {
        const auto back = out.count > 1 ? (out.count - 1 - i) * (points - 1) / (out.count - 1) : 0;
        out.trail[i] = hand->points[(hand->first + hand->count - 1 - back) % free_points];
    }
}

/// Index in the match's journal of events of the first event of the last `age` ticks.
std::uint64_t first_since(const EventJournal& events, Tick played, Tick age) {
    auto i = events.count();
    while (i > events.first() && events[i - 1].tick + age >= played) --i;
    return i;
}

/// Copies the shield: its remaining strength, and when it last began to flash. A hit during a flash starts no
/// new one.
void take_ward(const Simulation& match, const Health& health, std::uint32_t player, CastingPicture& out) {
    constexpr Tick after = ticks(1.0), longest = ticks(10.0);
    const auto played = match.match().played;
    out.ward = out.ward_share = 0;
    out.since_flash_s = 1e6;
    if (health.ward_until == 0 || played > health.ward_until + after) return;
    double taken = 0;
    std::optional<Tick> flash;
    const auto& events = match.events();
    for (auto i = first_since(events, played, longest); i < events.count(); ++i) {
        const auto& event = events[i];
        if (event.subject != player) continue;
        if (event.kind == EventKind::cast &&
            sign_of(*match.data().presentation, event.detail) == SpellSign::shell)
            taken = 0;
        if (event.kind != EventKind::held_off) continue;
        taken += event.amount;
        if (!flash || event.tick >= *flash + ticks(flash_apart_seconds)) flash = event.tick;
    }
    if (played < health.ward_until) out.ward = std::max(health.ward, 0.0);
    if (out.ward > 0) out.ward_share = out.ward / (out.ward + taken);
    if (flash && played >= *flash) out.since_flash_s = seconds(played - *flash);
}

/// Finds the thing that the wizard has just recalled.
std::optional<vec3> recalled_thing(const Simulation& match, ecs::Entity wizard,
                                   const ReadingPicture& reading) {
    constexpr double longest_s = 0.8;
    const bool recalls = reading.outcome == StrokeOutcome::cast && reading.age_s < longest_s &&
                         sign_of(*match.data().presentation, reading.event.detail) == SpellSign::beads;
    const auto* last = recalls ? match.world().find<LastProp>(wizard) : nullptr;
    const auto* motion = last != nullptr && last->thing ? match.world().find<Motion>(last->thing) : nullptr;
    return motion == nullptr ? std::nullopt : std::optional(motion->position);
}

}  // namespace

void take_casting(const Simulation& match, ecs::Entity wizard, std::uint32_t player, CastingPicture& out) {
    const auto& data = match.data();
    out.there = data.gestures != nullptr && data.casting.has_value();
    if (!out.there) return;
    out.rules = &*data.casting;
    const auto first =
        std::min_element(data.spells.begin(), data.spells.end(),
                         [](const auto& a, const auto& b) { return a.stats.slot < b.stats.slot; });
    out.first_spell = first == data.spells.end() ? nullptr : &first->stats;
    const auto* focus = match.world().find<Focus>(wizard);
    out.focus = focus == nullptr ? 0 : focus->points;
    out.focus_cap = data.casting->focus_cap;
    const auto& own = match.setup().gestures[player];
    out.gestures = own ? own : data.gestures;
    take_ward(match, match.world().get<Health>(wizard), player, out);
    take_stroke(match, wizard, player, out.stroke);
    take_slip(match, player, out);
    take_reading(match, wizard, player, out.reading);
    take_outcome(match, player, out);
    take_free(match, wizard, out.free);
    out.recalled = recalled_thing(match, wizard, out.reading);
}

std::string shown_gesture(const CastingPicture& casting, std::uint32_t gesture) {
    if (!casting.gestures || gesture >= casting.gestures->gestures().size()) return {};
    return capitalised(casting.gestures->gestures()[gesture].name);
}

}  // namespace thaum::game::inline picture
