#include "game/live/gesture_wall.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/bots/apprentice.h"
#include "game/casting/casting.h"
#include "game/casting/reading.h"
#include "game/components/casting.h"
#include "game/context/match_context.h"
#include "game/hud/stroke_words.h"
#include "gesture/comparison.h"

namespace thaum::app {
namespace {

using game::practising;

constexpr Tick shown_after = ticks(8.0);
constexpr double shortest_recorded = 0.15;  // shortest stroke that is recorded (s)

std::string words_of_force(const game::CastingRules& rules, double force) {
    return text(game::force_word(rules, force), " (", fixed(force, 1), " N)");
}

/// The gesture with the bands of force by which the match casts, in place of those of the gesture's file.
gesture::Gesture by_bands_of(const game::CastingRules& rules, gesture::Gesture gesture) {
    gesture.options.gentle_below = rules.gentle_below;
    gesture.options.harsh_above = rules.harsh_from;
    return gesture;
}

std::string spell_shown(const game::MatchData& data, const std::string& gesture) {
    const auto* spell = game::spell_of(data, gesture);
    return spell == nullptr ? std::string() : spell->stats.shown;
}

}  // namespace

/// Lists the ghosts of the player's gestures, where the set is another one.
void GestureWall::list(const game::Simulation& match) {
    const auto& own = match.setup().gestures[practising];
    const auto& set = own ? own : match.data().gestures;
    if (set == listed_) return;
    listed_ = set;
    std::vector<game::WallGesture> gestures;
    if (set != nullptr) {
        const auto& profile = match.setup().profile;
        for (const auto& g : set->gestures())
            gestures.push_back({.name = g.name,
                                .spell = spell_shown(match.data(), g.name),
                                .ghost = g.strokes.front(),
                                .own = std::any_of(profile.begin(), profile.end(), [&](const auto& item) {
                                    return item.name == g.name && item.player == practising;
                                })});
    }
    scores_.assign(gestures.size(), -1);
    chosen_ = -1;
    gestures_ = std::make_shared<const std::vector<game::WallGesture>>(std::move(gestures));
}

std::string GestureWall::words_of_haste() const {
    return text("too fast: ", fixed(stroke_.back().t, 1), " s; take a second");
}

/// Shows why a stroke was not even read.
void GestureWall::refuse(const game::Simulation& match) {
    lines_.clear();
    chosen_ = -1;
    if (stroke_.empty()) return;
    if (stroke_.back().t < seconds(match.data().casting->shortest))
        lines_.push_back(words_of_haste());
    else
        lines_.emplace_back("too small: draw 5 to 10 cm with the hand");
}

/// Shows the newest reading: the gesture, its score, and what to do better.
void GestureWall::read(const game::Simulation& match) {
    const auto& reading = match.world().get<game::LastReading>(game::wizard_of(match.world(), practising));
    read_at_ = reading.at;
    lines_.clear();
    chosen_ = -1;
    if (reading.nearest >= listed_->gestures().size()) {
        lines_.emplace_back("no gesture: draw one of these");
        return;
    }
    const auto& nearest = listed_->gestures()[reading.nearest];
    chosen_ = static_cast<int>(reading.nearest);
    const int score = game::whole_percent(reading.probability);
    const bool meant = reading.gesture != game::no_gesture;
    scores_[reading.nearest] = score;
    const auto& spell = (*gestures_)[reading.nearest].spell;
    if (meant)
        lines_.push_back(text(spell.empty() ? nearest.name : spell, ", ", score, " % sure, ",
                              words_of_force(*match.data().casting, reading.force)));
    else
        lines_.push_back(text("not sure: the nearest is ", nearest.name, ", ", score, " %"));
    if (chord_) return lines_.emplace_back("a key chord: nothing was drawn"), void();
    if (!meant && !stroke_.empty() && game::is_too_fast(*match.data().casting, reading.force))
        lines_.push_back(words_of_haste());
    for (auto& line : gesture::advice_on(gesture::compare(stroke_, nearest),
                                         by_bands_of(*match.data().casting, nearest), reading.force))
        lines_.push_back(std::move(line));
    if (meant && lines_.size() == 1) lines_.emplace_back("well drawn");
}

void GestureWall::tell_recording() {
    lines_ = {text("Your own ", recording_.name, ": draw stroke ", recording_.strokes.size() + 1, " of ",
                   recorded_strokes),
              "draw it the same way each time"};
}

/// Keeps a stroke for the gesture that is recorded.
void GestureWall::keep(const game::Simulation& match) {
    chosen_ = -1;
    double way = 0;
    for (std::size_t i = 1; i < stroke_.size(); ++i) way += glm::distance(stroke_[i - 1].at, stroke_[i].at);
    if (way < match.data().casting->smallest || stroke_.back().t < shortest_recorded) return;
    recording_.strokes.push_back(stroke_);
    if (recording_.strokes.size() < recorded_strokes) return tell_recording();
    if (!match.data().gestures->number(recording_.name)) {  // its file was deleted meanwhile
        lines_ = {text("there is no gesture ", recording_.name, " any more")};
        recording_ = {};
        return;
    }
    recording_.options = {.rotation = 15 * radians_per_degree, .planar = true};
    recorded_ = by_bands_of(*match.data().casting, std::move(recording_));
    recording_ = {};
    lines_ = {"three strokes: they are compared with the other gestures"};
}

void GestureWall::record(const std::string& name) {
    recording_ = {.name = name, .options = {}, .strokes = {}};
    chosen_ = -1;
    stroke_.clear();
    if (!name.empty()) tell_recording();
}

void GestureWall::say(std::vector<std::string> lines) { lines_ = std::move(lines); }

void GestureWall::follow(const game::Simulation& match) {
    list(match);
    if (listed_ == nullptr) return;
    const auto& world = match.world();
    const auto wizard = game::wizard_of(world, practising);
    const auto* drawn = world.find<game::DrawnStroke>(wizard);
    const auto now = match.match().played;
    if (drawn != nullptr) {
        // At the cauldron the card guides the strokes (hud/rim_card.h).
        if (drawn->on_brew != 0) return;
        if (match.now() % game::gameplay_period == 0) stroke_ = game::points_of(*drawn);
        chord_ = drawn->over == game::by_chord;
        drawing_ = true;
        shown_until_ = now + shown_after;
        return;
    }
    if (!drawing_) return;
    drawing_ = false;
    if (records())
        keep(match);
    else if (world.get<game::LastReading>(wizard).at != read_at_)
        read(match);
    else
        refuse(match);
}

void GestureWall::show(const game::Simulation& match, game::GestureWallPicture& picture) const {
    picture.on = listed_ != nullptr && (records() || drawing_ || match.match().played < shown_until_);
    if (!picture.on) return;
    picture.gestures = gestures_;
    picture.scores = scores_;
    picture.chosen = chosen_;
    picture.stroke = stroke_;
    picture.drawing = drawing_;
    picture.lines = lines_;
}

}  // namespace thaum::app
