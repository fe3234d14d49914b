#include "game/senses/sound/heard.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "core/units.h"

namespace thaum::game::inline senses {
namespace {

/// Limits within which a sound counts as the listener's own: distance along the ground, and height above or
/// below the ear (m). The listener's feet are 1.6 m below the ear.
constexpr double own_place = 1.2, own_height = 2;
/// Sine of the elevation beyond which a sound counts as above or below.
constexpr double steep = 0.8;
/// Minimum strength at the listener from which a voice (a playing sound) gets a caption, 0 to 1.
constexpr double min_strength = 0.02;

/// Strength of a voice (a playing sound) at the listener, from gain and distance alone, 0 to 1.
double strength_at(const audio::Listener& listener, const audio::Sound& sound, const audio::Voice& voice) {
    if (voice.at_ear) return voice.gain;
    const double distance = glm::distance(listener.position, voice.position);
    if (!(distance < sound.reach_m)) return 0;
    return voice.gain * std::min(1.0, sound.near_m / std::max(distance, 1e-6));
}

}  // namespace

HeardFrom side_of(const audio::Listener& listener, vec3 place) {
    const vec3 way = place - listener.position;
    const double distance = glm::length(way);
    const bool own = std::hypot(way.x, way.z) <= own_place && std::abs(way.y) <= own_height;
    if (own || !(distance > own_place)) return HeardFrom::here;
    const vec3 flat_ahead = vec3(listener.forward.x, 0, listener.forward.z);
    if (std::abs(way.y) > steep * distance || !(glm::length(flat_ahead) > 1e-6))
        return way.y > 0 ? HeardFrom::above : HeardFrom::below;
    const double ahead = way.x * flat_ahead.x + way.z * flat_ahead.z;
    const double right = way.z * flat_ahead.x - way.x * flat_ahead.z;
    if (std::abs(ahead) >= std::abs(right)) return ahead > 0 ? HeardFrom::ahead : HeardFrom::behind;
    return right > 0 ? HeardFrom::right : HeardFrom::left;
}

std::string words_of(const HeardLine& line) {
    const auto side = static_cast<std::size_t>(line.from);
    if (line.own) {
        const auto from = hurt_from_words.at(side);
        return text(line.words, from.empty() ? "" : " ", from);
    }
    if (line.verb.empty()) {
        const auto from = heard_from_words.at(side);
        return from.empty() ? std::string(line.words) : text(line.words, ", ", from);
    }
    const auto to = pushed_to_words.at(side);
    auto words = text(line.words, " ", line.verb, to.empty() ? "" : " ", to);
    if (words[0] >= 'A' && words[0] <= 'Z') words[0] = static_cast<char>(words[0] - 'A' + 'a');
    return words;
}

bool wants(HeardWish wish, const HeardLine& line) {
    return wish == HeardWish::all || (wish == HeardWish::important && line.important);
}

void HeardLines::add(const HeardLine& line) {
    const auto same = [&](const HeardLine& l) {
        return l.words == line.words && l.verb == line.verb && l.own == line.own &&
               (!l.verb.empty() || l.from == line.from);
    };
    const auto end = lines_.begin() + static_cast<std::ptrdiff_t>(count_);
    if (const auto found = std::find_if(lines_.begin(), end, same); found != end) {
        found->age_s = 0;
        found->from = line.from;
        return;
    }
    if (count_ == lines_.size()) {
        // If there is no room for another line, the oldest unimportant one is dropped, or else the oldest of
        // all.
        const auto plain =
            std::find_if(lines_.begin(), lines_.end(), [](const auto& l) { return !l.important; });
        const auto leaves = plain != lines_.end() ? plain : lines_.begin();
        std::move(leaves + 1, lines_.end(), leaves);
        --count_;
    }
    lines_.at(count_++) = line;
}

bool HeardLines::tells(const audio::SoundBank& bank, const audio::Voice& voice, bool loud) {
    if (bank.sounds[voice.sound].group != audio::SoundGroup::music || voice.sound >= music_.size())
        return loud;
    const bool heard = music_[voice.sound];
    music_[voice.sound] = loud;
    return loud && !heard;
}

void HeardLines::pass_frame() {
    for (std::size_t i = 0; i < count_; ++i) lines_.at(i).age_s += seconds(audio::frame_ticks);
    const auto end = lines_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto kept =
        std::remove_if(lines_.begin(), end, [](const HeardLine& l) { return l.age_s > heard_seconds; });
    count_ = static_cast<std::size_t>(kept - lines_.begin());
}

void HeardLines::follow(const audio::AudioFrame& frame, const audio::SoundBank& bank,
                        std::uint32_t listener) {
    const auto take = [&](const audio::Voice& voice) {
        if ((voice.heard_by & (1U << listener)) == 0 || voice.sound >= bank.sounds.size()) return;
        const auto& sound = bank.sounds[voice.sound];
        const auto& ears = frame.listeners.at(listener);
        const bool loud = strength_at(ears, sound, voice) >= min_strength;
        if (!tells(bank, voice, loud) || sound.caption.empty()) return;
        const bool sided = !voice.at_ear || voice.sided;
        add({.words = sound.caption,
             .from = sided ? side_of(ears, voice.position) : HeardFrom::here,
             .important = sound.important,
             .own = voice.sided});
    };
    for (const auto& voice : frame.lasts) take(voice);
    for (const auto& voice : frame.begins) take(voice);
}

}  // namespace thaum::game::inline senses
