#include "game/range/gesture_wall.h"

#include <algorithm>
#include <memory>

#include "core/text.h"
#include "game/components/casting.h"
#include "game/context/match_context.h"
#include "game/data/reading.h"
#include "game/range/apprentice.h"
#include "gesture/comparison.h"
#include "gesture/prefix.h"

namespace thaum::game::inline range {
namespace {

constexpr Tick shown_after = ticks(8.0);
constexpr double shortest_recorded = 0.15;  // minimum duration of a recorded stroke (s)

std::string words_of_force(const CastingRules& rules, double force) {
    return text(force_word(rules, force), " (", fixed(force, 1), " N)");
}

/// The gesture with the force limits by which the match casts spells, instead of those in the gesture's own
/// file.
gesture::Gesture by_bands_of(const CastingRules& rules, gesture::Gesture gesture) {
    gesture.options.gentle_below = rules.gentle_below;
    gesture.options.harsh_above = rules.harsh_from;
    return gesture;
}

std::string spell_shown(const MatchData& data, const std::string& gesture) {
    const auto* spell = spell_of(data, gesture);
    return spell == nullptr ? std::string() : spell->stats.shown;
}

/// Number of the gesture of which a stroke is probably the first part; no_gesture: none.
std::uint32_t gesture_begun(const game::GestureSet& gestures, gesture::Points stroke) {
    const auto space = std::make_unique<gesture::PrefixSpace>();  // too large for the stack, so on the heap
    const auto likely = gestures.prefixes().read(stroke, *space);
    return likely.probability >= gesture::likely_enough ? likely.gesture : game::no_gesture;
}

/// Length of a stroke's path (m).
double way_of(gesture::Points stroke) {
    double way = 0;
    for (std::size_t i = 1; i < stroke.size(); ++i) way += glm::distance(stroke[i - 1].at, stroke[i].at);
    return way;
}

}  // namespace

/// Makes the list of the player's gestures with an example stroke of each (its ghost), if the set of gestures
/// has changed.
void GestureWall::list(const Simulation& match) {
    const auto& own = match.setup().gestures[practising];
    const auto& set = own ? own : match.data().gestures;
    if (set == listed_) return;
    listed_ = set;
    std::vector<WallGesture> gestures;
    if (set != nullptr) {
        const auto& profile = match.setup().profile;
        for (const auto& g : set->gestures())
            gestures.push_back({.name = capitalised(g.name),
                                .spell = spell_shown(match.data(), g.name),
                                .ghost = g.strokes.front(),
                                .own = std::any_of(profile.begin(), profile.end(), [&](const auto& item) {
                                    return item.name == g.name && item.player == practising;
                                })});
    }
    scores_.assign(gestures.size(), -1);
    chosen_ = -1;
    gestures_ = std::make_shared<const std::vector<WallGesture>>(std::move(gestures));
}

std::string GestureWall::words_of_haste() const {
    return text("too fast: ", fixed(stroke_.back().t, 1), " s; take a second");
}

/// Why a stroke was not read, or is not accepted for a recorded gesture: too small or too fast.
std::string GestureWall::words_of_slip(const CastingRules& rules, double shortest) const {
    if (way_of(stroke_) >= rules.smallest || stroke_.back().t < shortest) return words_of_haste();
    return "too small: draw 5 to 10 cm with the hand";
}

/// Shows why a stroke was not read.
void GestureWall::refuse(const Simulation& match) {
    lines_.clear();
    if (stroke_.empty()) return;
    const auto& rules = *match.data().casting;
    lines_.push_back(words_of_slip(rules, seconds(rules.shortest)));
}

/// Number of the gesture that an unrecognised stroke was probably meant to be. It is one with the same shape
/// but another direction or rotation, or else the recogniser's nearest gesture, if that is likely at all.
/// no_gesture: none.
std::uint32_t GestureWall::gesture_tried(std::uint32_t nearest, int score) const {
    std::uint32_t tried = score > 0 ? nearest : no_gesture;
    double least = 1;
    for (std::uint32_t g = 0; !chord_ && g < listed_->gestures().size(); ++g) {
        const auto& gesture = listed_->gestures()[g];
        const auto difference = gesture::compare(stroke_, gesture);
        if (!gesture::is_turned_copy(difference, gesture) || difference.deviation >= least) continue;
        least = difference.deviation;
        tried = g;
    }
    return tried;
}

/// Shows the newest reading: the gesture, its score, and advice.
void GestureWall::read(const Simulation& match) {
    const auto& reading = match.world().get<LastReading>(wizard_of(match.world(), practising));
    read_at_ = reading.at;
    lines_.clear();
    const auto& rules = *match.data().casting;
    const bool meant = reading.gesture < listed_->gestures().size();
    const int score = game::whole_percent(reading.probability);
    auto number = meant ? reading.gesture : gesture_tried(reading.nearest, score);
    const bool is_part = number == game::no_gesture && !chord_;
    if (is_part) number = gesture_begun(*listed_, stroke_);
    if (number >= listed_->gestures().size()) {
        lines_.emplace_back("not read: it is like none of these");
        if (!chord_)
            lines_.push_back(game::is_too_fast(rules, reading.force) ? words_of_haste()
                                                                     : "follow a pale line to its end");
        return;
    }
    chosen_ = static_cast<int>(number);
    // An unrecognised stroke gets no score: its probability depends on how often the player scribbles without
    // meaning a gesture.
    scores_[number] = meant ? score : -1;
    const auto& shown = (*gestures_)[number];
    if (meant)
        lines_.push_back(text(shown.spell.empty() ? shown.name : shown.spell, ", ", score, " % sure, ",
                              words_of_force(rules, reading.force)));
    else if (is_part)
        lines_.push_back(text("not read: it may be a part of ", shown.name));
    else if (number == reading.nearest && score > 0)
        lines_.push_back(text("not sure: the nearest is ", shown.name));
    else
        lines_.push_back(text("not read, but it has the shape of ", shown.name));
    if (chord_) return lines_.emplace_back("a key chord: nothing was drawn"), void();
    advise(rules, listed_->gestures()[number], reading.force, meant);
}

/// Adds advice on how to draw the gesture better.
void GestureWall::advise(const CastingRules& rules, const gesture::Gesture& gesture, double force,
                         bool meant) {
    if (!meant && is_too_fast(rules, force)) lines_.push_back(words_of_haste());
    for (auto& line :
         gesture::advice_on(gesture::compare(stroke_, gesture), by_bands_of(rules, gesture), force, meant))
        lines_.push_back(std::move(line));
    if (lines_.size() == 1) lines_.emplace_back(meant ? "well drawn" : "draw it slower, along the pale line");
}

/// Says which stroke of the recorded gesture comes next, and how to cancel.
void GestureWall::tell_recording() {
    lines_.push_back(text("Your own ", capitalised(recording_.name), ": draw stroke ",
                          recording_.strokes.size() + 1, " of ", recorded_strokes));
    lines_.emplace_back(recording_.strokes.empty() ? "in any shape" : "the same way each time");
    lines_.emplace_back("to give up: {pause}, then Give up drawing");
}

/// Stores a stroke of the gesture that is being recorded.
void GestureWall::keep(const Simulation& match) {
    if (checked_ || stroke_.empty()) return;
    const auto& rules = *match.data().casting;
    lines_.clear();
    if (way_of(stroke_) < rules.smallest || stroke_.back().t < shortest_recorded) {
        lines_.push_back(text("not counted, ", words_of_slip(rules, shortest_recorded)));
        return tell_recording();
    }
    recording_.strokes.push_back(stroke_);
    if (recording_.strokes.size() < recorded_strokes) return tell_recording();
    if (!match.data().gestures->number(recording_.name)) {  // the gesture's file was deleted in the meantime
        lines_ = {text("there is no gesture ", capitalised(recording_.name), " any more")};
        return record({});
    }
    recording_.options = {.rotation = 15 * radians_per_degree, .planar = true};
    recorded_ = by_bands_of(rules, recording_);
    checked_ = true;
    lines_ = {"three strokes: they are compared with the other gestures"};
}

void GestureWall::record(const std::string& name) {
    recording_ = {.name = name, .options = {}, .strokes = {}};
    checked_ = false;
    chosen_ = -1;
    stroke_.clear();
    if (name.empty()) return;
    lines_.clear();
    tell_recording();
}

void GestureWall::draw_again(std::vector<std::string> why) {
    if (!records()) return;  // the player has cancelled in the meantime
    record(recording_.name);
    why.push_back(text("try another shape: draw stroke 1 of ", recorded_strokes));
    why.push_back(lines_.back());
    lines_ = std::move(why);
}

void GestureWall::give_up(const Simulation& match) {
    if (!records()) return;
    const auto name = capitalised(recording_.name);
    recorded_.reset();
    record({});
    say(match, {text("given up: ", name, " is as it was before")});
}

void GestureWall::say(const Simulation& match, std::vector<std::string> lines) {
    lines_ = std::move(lines);
    shown_until_ = match.match().played + shown_after;
}

/// Clears what is shown of the last stroke. Text about a recording stays.
void GestureWall::begin_stroke() {
    chosen_ = -1;
    stroke_.clear();
    if (!records()) lines_.clear();
}

void GestureWall::follow(const Simulation& match) {
    list(match);
    if (listed_ == nullptr) return;
    const auto& world = match.world();
    const auto wizard = wizard_of(world, practising);
    const auto* drawn = world.find<DrawnStroke>(wizard);
    const auto now = match.match().played;
    if (drawn != nullptr) {
        // No display for a stroke at the cauldron: there a panel (hud/rim_card.h) helps with strokes.
        if (drawn->on_brew != 0) return;
        if (!drawing_) begin_stroke();
        if (match.now() % gameplay_period == 0) stroke_ = points_of(*drawn);
        chord_ = drawn->over == by_chord;
        drawing_ = true;
        shown_until_ = now + shown_after;
        return;
    }
    if (!drawing_) return;
    drawing_ = false;
    if (records())
        keep(match);
    else if (world.get<LastReading>(wizard).at != read_at_)
        read(match);
    else
        refuse(match);
}

void GestureWall::show(const Simulation& match, GestureWallPicture& picture) const {
    picture.on = listed_ != nullptr && (records() || drawing_ || match.match().played < shown_until_);
    if (!picture.on) return;
    picture.gestures = gestures_;
    picture.scores = scores_;
    picture.chosen = chosen_;
    picture.stroke = stroke_;
    picture.drawing = drawing_;
    picture.lines = lines_;
}

}  // namespace thaum::game::inline range
