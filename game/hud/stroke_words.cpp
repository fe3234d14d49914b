#include "game/hud/stroke_words.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/data/reading.h"
#include "game/data/spell.h"

namespace thaum::game::inline hud {
namespace {

std::string gesture_and_percent(const CastingPicture& casting, std::uint32_t gesture) {
    const auto name = shown_gesture(casting, gesture);
    return text(name.empty() ? "Own gesture" : name, " ", whole_percent(casting.reading.probability), " %");
}

/// Name of the spell that the recognised gesture casts; empty if it casts none.
std::string spell_of(const CastingPicture& casting, const Presentation& shown) {
    const auto number = casting.reading.gesture;
    if (!casting.gestures || number >= casting.gestures->gestures().size()) return {};
    const auto& gesture = casting.gestures->gestures()[number].name;
    for (const auto& spell : shown.spells)
        if (spell.gesture == gesture) return spell.shown;
    return {};
}

std::string words_of_miss(const CastingPicture& casting) {
    const auto& reading = casting.reading;
    if (reading.gesture != no_gesture)
        return text(gesture_and_percent(casting, reading.gesture), ": no spell");
    const auto* why = is_too_fast(*casting.rules, reading.force) ? "too fast" : "not read";
    const bool is_like_none = whole_percent(reading.probability) == 0;
    if (is_like_none || shown_gesture(casting, reading.nearest).empty()) return why;
    // The caption has no probability, because that depends on how often the player scribbles without meaning
    // a gesture.
    return text(why, "; nearest: ", shown_gesture(casting, reading.nearest));
}

/// Name in brackets of the wand key that casts a spell while the button Trace is held: "[1]".
std::string key_of(std::uint32_t slot, const ControlNames& controls) {
    const bool named = slot < controls.wands.size() && !controls.wands[slot].empty();
    return named ? text("[", controls.wands[slot], "]") : text("[", slot + 1, "]");
}

/// Text about a stroke and its spell: "Circle 97 %: Shield", or "[1] Shield" if a wand key has cast it with
/// Trace held.
std::string words_of_cast(const CastingPicture& casting, const Presentation& shown,
                          const ControlNames& controls) {
    const auto& reading = casting.reading;
    const auto spell = spell_of(casting, shown);
    if (reading.chord) return text(key_of(*reading.chord, controls), " ", spell);
    return text(gesture_and_percent(casting, reading.gesture), ": ", spell);
}

/// Text about a stroke on the brew: "Circle 97 %, 2 turns, gentle".
std::string words_on_brew(const CastingPicture& casting, const ControlNames& controls) {
    const auto& reading = casting.reading;
    if (reading.gesture == no_gesture) return words_of_miss(casting);
    auto words = reading.chord
                     ? text(key_of(*reading.chord, controls), " ", shown_gesture(casting, reading.gesture))
                     : gesture_and_percent(casting, reading.gesture);
    const auto turns = std::lround(std::abs(reading.turns));
    if (turns > 0)
        words += text(", ", turns, turns == 1 ? " turn " : " turns ",
                      reading.turns > 0 ? "clockwise" : "counterclockwise");
    return text(words, ", ", force_word(*casting.rules, reading.force));
}

/// Why free casting (without a button) cast nothing, in words.
std::string_view words_of(Miss reason) {
    switch (reason) {
        case Miss::none: break;
        case Miss::unclear: return "not clear enough";
        case Miss::too_fast: return "too fast";
        case Miss::too_small: return "too small";
        case Miss::too_soon: return "too soon after the last spell";
    }
    return {};
}

std::string_view words_of(Slip slip) {
    switch (slip) {
        case Slip::none:
        case Slip::tap: break;
        case Slip::too_small: return "too small to be read: draw it larger";
        case Slip::too_quick: return "too short to be read: draw it more slowly";
    }
    return {};
}

/// Text about a gesture that was almost cast without a button: "almost: Star 60 %, not clear enough".
std::string words_of_near_miss(const CastingPicture& casting) {
    const auto& miss = casting.free.miss;
    return text("almost: ", shown_gesture(casting, miss.gesture), " ", whole_percent(miss.probability),
                " %, ", words_of(miss.reason));
}

}  // namespace

StrokeCaption stroke_caption(const CastingPicture& casting, const Presentation& shown,
                             const ControlNames& controls) {
    const auto& reading = casting.reading;
    if (!casting.there || casting.rules == nullptr) return {};
    const double missed_s = casting.free.miss_age_s;
    const auto slip = words_of(casting.slip);
    const double slip_s = slip.empty() ? reading_seconds : casting.slip_age_s;
    const double newest_s = std::min({missed_s, reading.age_s, reading_seconds});
    if (!casting.outcome.empty() && casting.outcome_age_s < std::min(newest_s, slip_s))
        return {casting.outcome, true};
    if (slip_s < newest_s) return {std::string(slip), true};
    if (missed_s < reading.age_s && missed_s <= reading_seconds) return {words_of_near_miss(casting), true};
    if (reading.age_s > reading_seconds) return {};
    const auto about = words_of_cast(casting, shown, controls);
    switch (reading.outcome) {
        case StrokeOutcome::none: return {words_on_brew(casting, controls), reading.gesture == no_gesture};
        case StrokeOutcome::cast:
            return {text(about, ", ", force_word(*casting.rules, reading.force)), false};
        case StrokeOutcome::unread: return {words_of_miss(casting), true};
        case StrokeOutcome::unfocused:
            return {text(about, " needs ", std::lround(std::ceil(reading.event.amount)), " more focus"),
                    true};
        case StrokeOutcome::fizzled:
            return {text(about, reading.refusal.empty() ? " does nothing here" : ", but ", reading.refusal),
                    true};
    }
    return {};
}

}  // namespace thaum::game::inline hud
