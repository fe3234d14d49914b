#include "tactile/mixer.h"

#include <algorithm>
#include <memory>

#include "core/assert.h"
#include "core/text.h"

namespace thaum::tactile {
namespace {

/// A motor with 256 steps plays smaller amplitudes as 0, so they count as 0.
constexpr double min_amplitude = 1.0 / 256;
/// A frame shows what effects do in the time since the last frame, but at most in this time (ms).
constexpr double longest_frame = 1000;

/// True for a jacket whose actuators are the cells of a clip (a recording), in their order.
bool has_cells_of_a_clip(const Layout& layout) {
    if (layout.actuators.size() != clip_cells) return false;
    for (std::size_t i = 0; i < clip_cells; ++i) {
        if (layout.actuators[i].place.part != clip_place(i).part) return false;
    }
    return true;
}

constexpr BodyPoint chest{Part::front, {0, 1.2, 0.115}};

}  // namespace

TactileMixer::TactileMixer(const Layout& layout, const EffectBank& bank, const MixerSettings& settings)
    : layout_(&layout), bank_(&bank), settings_(settings) {
    for (std::size_t i = 0; i < max_playing; ++i) order_[i] = static_cast<std::uint8_t>(i);
    frame_.count = layout.actuators.size();
    frame_.time_to_live = settings.time_to_live;
    const bool has_clips = std::any_of(bank.effects.begin(), bank.effects.end(),
                                       [](const Effect& effect) { return effect.pattern == Pattern::clip; });
    const bool jacket = has_cells_of_a_clip(layout);
    for (std::size_t i = 0; i < clip_cells && has_clips; ++i) {
        if (jacket)
            clip_shares_[i][i] = 1;
        else
            clip_shares_[i] = phantom(layout, layout.chart_place(clip_place(i)), vec2(0)).shares;
    }
}

double TactileMixer::checked(double value) {
    if (value >= 0 && value <= 1) return value;
    ++counts_.clipped;
    return value > 1 ? 1 : 0;  // NaN becomes 0
}

void TactileMixer::set_faders(const Faders& faders) {
    for (std::size_t i = 0; i < purpose_count; ++i) faders_.values[i] = checked(faders.values[i]);
}

void TactileMixer::set_pose(const Pose& pose) {
    const bool finite = std::all_of(pose.parts.begin(), pose.parts.end(), [](const Transform& t) {
        return is_finite(t.shift) && std::isfinite(t.turn.w + t.turn.x + t.turn.y + t.turn.z);
    });
    if (finite)
        pose_ = pose;
    else
        ++counts_.clipped;
}

// ---- starting effects ------------------------------------------------------------------------------------

BodyPoint TactileMixer::point_of(const Where& where) {
    constexpr double farthest = 10;  // largest distance of a place from the body (m)
    const auto near = [](vec3 v) { return is_finite(v) && glm::length(v) < farthest; };
    switch (where.kind) {
        case Where::Kind::own: return chest;
        case Where::Kind::on_part:
            if (near(where.point.at)) return where.point;
            break;
        case Where::Kind::touched:
            if (near(where.point.at)) return layout_->nearest(pose_, where.point.at);
            break;
        case Where::Kind::from:
            if (is_finite(where.direction) && std::abs(where.height) < farthest)
                return layout_->facing(where.direction, where.height);
            break;
    }
    ++counts_.clipped;
    return chest;
}

void TactileMixer::place(Playing& playing, const Effect& effect, const Where& where) {
    if (effect.pattern == Pattern::clip) return place_clip(playing, effect);
    const bool own = !effect.places.empty();
    const BodyPoint first = own ? effect.places[0] : point_of(where);
    if (effect.pattern == Pattern::sweep) return place_sweep(playing, effect, first);
    const auto found = phantom(*layout_, layout_->chart_place(first), effect.sigma_cells);
    playing.main = found.strongest;
    if (effect.pattern == Pattern::spread) return place_spread(playing, first);
    playing.places[0] = found.shares;
    if (!own || effect.places.size() < 2) return;
    const auto other = phantom(*layout_, layout_->chart_place(effect.places[1]), effect.sigma_cells);
    for (std::size_t i = 0; i < max_actuators; ++i)
        playing.places[0][i] = (found.shares[i] + other.shares[i]) / 2;
}

void TactileMixer::place_spread(Playing& playing, const BodyPoint& from) {
    const auto start = layout_->chart_place(from);
    const vec3 start_point = posed(pose_, from.part, from.at);
    auto& distances = playing.places[0];
    float nearest = 1e9F;
    for (std::size_t i = 0; i < layout_->actuators.size(); ++i) {
        const auto& at = layout_->actuators[i].place;
        const vec3 way = posed(pose_, at.part, at.at) - start_point;
        distances[i] = static_cast<float>(std::sqrt(glm::dot(way, way)));
    }
    for (const auto i : layout_->group(start.region)) {
        const vec2 way = layout_->between(start.region, start.at, layout_->chart_of(start.region, i));
        distances[i] = static_cast<float>(std::sqrt(glm::dot(way, way)));
        nearest = std::min(nearest, distances[i]);
    }
    // The wave begins at the nearest actuator, so that it is felt at once.
    for (std::size_t i = 0; i < layout_->actuators.size(); ++i)
        distances[i] = std::max(0.0F, distances[i] - nearest);
}

void TactileMixer::place_sweep(Playing& playing, const Effect& effect, const BodyPoint& from) {
    THAUM_ASSERT(effect.to, text("the sweep '", effect.name, "' has no end"));
    const auto start = layout_->chart_place(from), end = layout_->chart_place(*effect.to);
    const vec2 way = layout_->between(start.region, start.at, end.at);
    for (std::size_t k = 0; k < max_places; ++k) {
        const double part = static_cast<double>(k) / (max_places - 1);
        ChartPlace at{start.region, start.at + part * way};
        if (start.region != end.region) at = part < 0.5 ? start : end;
        const auto found = phantom(*layout_, at, effect.sigma_cells);
        playing.places[k] = found.shares;
        if (k == 0) playing.main = found.strongest;
    }
}

/// Finds the place where a clip (a recording) begins: the strongest cell of its first frame that is not
/// silent.
void TactileMixer::place_clip(Playing& playing, const Effect& effect) {
    for (const auto& frame : effect.clip) {
        const auto strongest = std::max_element(frame.strength.begin(), frame.strength.end());
        if (*strongest == 0) continue;
        const auto& shares = clip_shares_[static_cast<std::size_t>(strongest - frame.strength.begin())];
        const auto main = std::max_element(shares.begin(), shares.end());
        playing.main = static_cast<std::uint8_t>(main - shares.begin());
        return;
    }
}

/// The latest event (effect that was started) that plays or waits at an actuator; null if there is none.
TactileMixer::Playing* TactileMixer::running_at(std::uint8_t actuator, Tick now) {
    Playing* latest = nullptr;
    for (std::size_t i = 0; i < count_; ++i) {
        auto& p = playing_[order_[i]];
        const double age = static_cast<double>(now) - static_cast<double>(p.begin);
        if (p.key != 0 || p.main != actuator || age >= effect_of(p).duration_ms()) continue;
        if (latest == nullptr || p.begin > latest->begin) latest = &p;
    }
    return latest;
}

/// The effect of lowest priority, or the oldest one of several with this priority; null if there is none.
/// `felt`: consider only effects that have already been in a frame.
TactileMixer::Playing* TactileMixer::least_important(bool felt) {
    Playing* least = nullptr;
    for (std::size_t i = 0; i < count_; ++i) {
        auto& p = playing_[order_[i]];
        if (felt && !p.felt) continue;
        const int rank = effect_of(p).priority, min_rank = least == nullptr ? 0 : effect_of(*least).priority;
        if (least == nullptr || rank < min_rank || (rank == min_rank && p.begin < least->begin)) least = &p;
    }
    return least;
}

/// Room for one more effect of this priority; null if all room is taken by more important effects, or by
/// effects that have not been felt yet.
TactileMixer::Playing* TactileMixer::free_place(int priority) {
    if (count_ < max_playing) return &playing_[order_[count_++]];
    auto* least = least_important(true);
    if (least == nullptr || effect_of(*least).priority > priority) return nullptr;
    ++counts_.replaced;
    return least;
}

/// Starts an event at once if its actuator is free. Within the gap (the least time between two beginnings at
/// one actuator) the event waits, or is merged with another one.
void TactileMixer::schedule(Playing& next, Tick now) {
    auto& free_at = free_at_[next.main];
    // An event that waits begins a gap (least time between two beginnings) of its own, so an actuator is
    // taken for at most two gaps. If it seems taken for longer, time has jumped back.
    const bool in_gap = free_at > now && free_at - now <= 2 * settings_.gap;
    auto* running = in_gap || count_ == max_playing ? running_at(next.main, now) : nullptr;
    if (in_gap && running != nullptr) {
        ++counts_.merged;
        next.begin = std::max(now, running->begin);
        if (next.level > running->level) *running = next;
        return;
    }
    if (in_gap) next.begin = free_at;
    auto* place = free_place(effect_of(next).priority);
    if (place == nullptr) {  // no room: an effect that plays goes on, and becomes as strong as the new event
        auto& kept = running != nullptr ? *running : *least_important(false);
        ++counts_.merged;
        kept.level = std::max(kept.level, next.level);
        return;
    }
    *place = next;
    free_at = next.begin + settings_.gap;
    ++counts_.started;
    if (in_gap) ++counts_.delayed;
}

void TactileMixer::start(std::uint32_t effect, const Where& where, double strength, Tick now) {
    THAUM_ASSERT(effect < bank_->effects.size(), text("there is no effect ", effect));
    ++counts_.offered;
    Playing next;
    next.effect = effect;
    next.begin = now;
    next.held_ms = -1;
    next.strength = checked(strength);
    next.level = effect_of(next).level(next.strength);
    place(next, effect_of(next), where);
    schedule(next, now);
}

void TactileMixer::drive(std::uint32_t key, std::uint32_t effect, const Where& where, double strength,
                         Tick now) {
    THAUM_ASSERT(effect < bank_->effects.size(), text("there is no effect ", effect));
    THAUM_ASSERT(key != 0, "a driven effect needs a key other than 0");
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto known = std::find_if(order_.begin(), end, [&](std::uint8_t i) {
        return playing_[i].key == key && playing_[i].effect == effect && playing_[i].held_ms < 0;
    });
    Playing* playing = known == end ? free_place(bank_->effects[effect].priority) : &playing_[*known];
    if (playing == nullptr) {
        ++counts_.not_driven;
        return;
    }
    if (known == end) {
        *playing = {};
        playing->effect = effect;
        playing->key = key;
        playing->begin = now;
        playing->held_ms = -1;
    }
    playing->driven_at = now;
    playing->strength = checked(strength);
    playing->level = effect_of(*playing).level(playing->strength);
    if (known == end || effect_of(*playing).places.empty()) place(*playing, effect_of(*playing), where);
}

void TactileMixer::remove(std::size_t place) {
    --count_;
    std::swap(order_[place], order_[count_]);
}

void TactileMixer::stop() {
    count_ = 0;
    free_at_.fill(0);
    may_begin_.fill(0);
    on_.fill(false);
    waiting_.fill(0);
    ringing_ = false;
    mixed_ = false;
    frame_.amplitude.fill(0);
}

// ---- making frames ---------------------------------------------------------------------------------------

/// Part of the effect's time that the frame covers: the time since the last frame. An effect that `drive`
/// keeps alive stays at full strength (the hold of its envelope) until it is released.
TactileMixer::Span TactileMixer::span_of(const Playing& playing, double ms) const {
    const auto& envelope = effect_of(playing).envelope;
    double to = static_cast<double>(mixed_at_) - static_cast<double>(playing.begin);
    if (playing.key != 0) {
        const double held = envelope.attack + envelope.hold;
        if (playing.held_ms < 0) {
            to = std::min(to, held);
        } else {
            to = playing.held_ms + static_cast<double>(mixed_at_) - static_cast<double>(playing.released);
        }
    }
    return {std::max(0.0, to - ms), to};
}

void TactileMixer::add_shares(const Playing& playing, double amplitude, const Shares& shares) {
    const auto energy = static_cast<float>(amplitude * amplitude);
    const auto carrier = static_cast<float>(effect_of(playing).carrier());
    for (std::size_t i = 0; i < layout_->actuators.size(); ++i) {
        const float part = energy * shares[i];
        energy_[i] += part;
        const bool stronger = part > strongest_[i];
        strongest_[i] = stronger ? part : strongest_[i];
        frame_.carrier_hz[i] = stronger ? carrier : frame_.carrier_hz[i];
    }
}

void TactileMixer::add_spread(const Playing& playing, const Effect& effect, Span span) {
    Shares energies{};
    const auto& distances = playing.places[0];
    for (std::size_t i = 0; i < layout_->actuators.size(); ++i) {
        const double fading = 1 - distances[i] / effect.reach;
        if (fading <= 0) continue;
        const double late = 1000 * distances[i] / effect.speed;
        const double amplitude = fading * effect.envelope.peak(span.from - late, span.to - late);
        energies[i] = static_cast<float>(amplitude * amplitude);
    }
    add_shares(playing, playing.level * faders_.values[static_cast<std::size_t>(effect.purpose)], energies);
}

void TactileMixer::add_sweep(const Playing& playing, const Effect& effect, double amplitude, double ms) {
    const double way = std::clamp(ms / effect.length_ms, 0.0, 1.0) * (max_places - 1);
    const auto k = std::min(static_cast<std::size_t>(way), max_places - 2);
    const auto part = static_cast<float>(way - static_cast<double>(k));
    Shares between{};
    for (std::size_t i = 0; i < layout_->actuators.size(); ++i)
        between[i] = playing.places[k][i] + part * (playing.places[k + 1][i] - playing.places[k][i]);
    add_shares(playing, amplitude, between);
}

void TactileMixer::add_clip(const Playing& playing, const Effect& effect, double amplitude, Span span) {
    constexpr auto frame_ms = static_cast<double>(clip_frame_ticks);
    Shares energies{};
    const auto last = static_cast<std::size_t>(span.to / frame_ms);
    for (auto f = static_cast<std::size_t>(span.from / frame_ms); f <= last && f < effect.clip.size(); ++f) {
        Shares in_frame{};
        for (std::size_t cell = 0; cell < clip_cells; ++cell) {
            const float strength = static_cast<float>(effect.clip[f].strength[cell]) / 100;
            if (strength == 0) continue;
            for (std::size_t i = 0; i < layout_->actuators.size(); ++i)
                in_frame[i] += strength * strength * clip_shares_[cell][i];
        }
        for (std::size_t i = 0; i < layout_->actuators.size(); ++i)
            energies[i] = std::max(energies[i], in_frame[i]);
    }
    add_shares(playing, amplitude, energies);
}

/// Adds the beats of a heartbeat that fall into the frame. Returns false after the last beat.
bool TactileMixer::add_heartbeat(Playing& playing, bool held, double ms) {
    const auto& effect = effect_of(playing);
    const double rate = effect.slowest_hz + (effect.fastest_hz - effect.slowest_hz) * playing.strength;
    const double period = 1000 / rate;
    playing.beat_ms += ms;
    if (playing.beat_ms >= period) {
        if (!held) return false;
        playing.beat_ms -= period;
    }
    const double to = playing.beat_ms, from = to - ms;
    const double beat =
        std::max(effect.envelope.peak(std::max(0.0, from), to),
                 second_beat * effect.envelope.peak(from - second_beat_ms, to - second_beat_ms));
    add_shares(playing, beat * playing.level * faders_.values[static_cast<std::size_t>(effect.purpose)],
               playing.places[0]);
    return true;
}

/// Ends the hold, the time at full strength, of an effect. Its decay begins at the strength that the attack
/// has reached.
void TactileMixer::release(Playing& playing, Tick now) {
    const auto& envelope = effect_of(playing).envelope;
    const double age = static_cast<double>(now) - static_cast<double>(playing.begin);
    const double risen = envelope.attack > 0 ? std::min(1.0, age / envelope.attack) : 1;
    playing.held_ms = envelope.attack + envelope.hold + envelope.decay * (1 - risen);
    playing.released = now;
}

/// Adds the energy of one effect to the frame that is being made. Returns false when the effect has ended, or
/// begins in the future because time has jumped back.
bool TactileMixer::add(Playing& playing, Tick now, double ms) {
    const Tick ahead = 2 * settings_.gap;  // longest time for which an event waits to begin
    if (playing.begin > now) return playing.begin - now <= ahead;
    playing.felt = true;
    const auto& effect = effect_of(playing);
    const bool driven = now <= playing.driven_at + settings_.driven_for && playing.driven_at <= now + ahead;
    if (playing.key != 0 && playing.held_ms < 0 && !driven) release(playing, now);
    const double age = static_cast<double>(now) - static_cast<double>(playing.begin);
    if (effect.pattern == Pattern::heartbeat) {
        const bool held = playing.key != 0 ? playing.held_ms < 0 : age < effect.length_ms;
        return add_heartbeat(playing, held, std::min(ms, age));
    }
    const auto span = span_of(playing, ms);
    const double fader = faders_.values[static_cast<std::size_t>(effect.purpose)];
    switch (effect.pattern) {
        case Pattern::heartbeat: break;
        case Pattern::single:
            add_shares(playing, fader * playing.level * effect.envelope.peak(span.from, span.to),
                       playing.places[0]);
            break;
        case Pattern::spread: add_spread(playing, effect, span); break;
        case Pattern::clip:
            add_clip(playing, effect, fader * playing.level, {std::max(0.0, age - ms), age});
            break;
        case Pattern::sweep:
            add_sweep(playing, effect, fader * playing.level * effect.envelope.peak(span.from, span.to), age);
            break;
    }
    if (effect.pattern == Pattern::clip) return age - ms < effect.duration_ms();
    const bool over = playing.key == 0 ? span.from >= effect.duration_ms()
                                       : span.from >= effect.duration_ms() + effect.envelope.length();
    return !over;
}

/// Lets an actuator begin now, or makes it wait until the gap (the least time between two beginnings) since
/// its last beginning is over.
double TactileMixer::pass_gap(std::size_t actuator, double amplitude, Tick now) {
    auto& waiting = waiting_[actuator];
    const double wanted = std::max(amplitude, waiting);
    if (on_[actuator] && amplitude > 0) return amplitude;
    on_[actuator] = false;
    if (wanted == 0) return 0;
    const bool in_gap = may_begin_[actuator] > now && may_begin_[actuator] - now <= settings_.gap;
    if (in_gap) {
        if (waiting == 0) ++counts_.held;
        waiting = wanted;
        return 0;
    }
    waiting = 0;
    on_[actuator] = true;
    may_begin_[actuator] = now + settings_.gap;
    return wanted;
}

void TactileMixer::limit(Tick now) {
    double sum = 0;
    ringing_ = false;
    for (std::size_t i = 0; i < layout_->actuators.size(); ++i) {
        const auto& actuator = layout_->actuators[i];
        double amplitude = std::min(std::sqrt(static_cast<double>(energy_[i])), actuator.limit);
        if (amplitude < min_amplitude) amplitude = 0;
        amplitude = pass_gap(i, amplitude, now);
        sum += amplitude * amplitude;
        ringing_ = ringing_ || on_[i] || waiting_[i] > 0;
        frame_.amplitude[i] = static_cast<float>(amplitude);
        frame_.carrier_hz[i] = std::clamp(frame_.carrier_hz[i], static_cast<float>(actuator.lowest_hz),
                                          static_cast<float>(actuator.highest_hz));
    }
    if (sum <= settings_.sum_limit) return;
    ++counts_.limited;
    const auto scale = static_cast<float>(std::sqrt(settings_.sum_limit / sum) * (1 - 1e-6));
    for (std::size_t i = 0; i < layout_->actuators.size(); ++i) frame_.amplitude[i] *= scale;
}

const TactileFrame& TactileMixer::mix(Tick now) {
    const bool forward = mixed_ && now > mixed_at_;
    const double ms = forward ? std::min(static_cast<double>(now - mixed_at_), longest_frame)
                              : static_cast<double>(frame_ticks);
    mixed_at_ = now;
    mixed_ = true;
    frame_.tick = now;
    if (count_ == 0 && !ringing_) return frame_;
    energy_.fill(0);
    strongest_.fill(0);
    for (std::size_t i = 0; i < count_;) {
        if (add(playing_[order_[i]], now, ms))
            ++i;
        else
            remove(i);
    }
    limit(now);
    return frame_;
}

std::vector<TactileFrame> rendered(const Effect& effect, const Layout& layout, double strength,
                                   const Where& where) {
    const EffectBank bank{{effect}};
    const auto mixer = std::make_unique<TactileMixer>(layout, bank);
    Faders full;
    full.values.fill(1);
    mixer->set_faders(full);
    mixer->start(0, where, strength, 0);
    std::vector<TactileFrame> frames;
    for (Tick tick = 0; frames.empty() || mixer->playing() > 0; tick += frame_ticks)
        frames.push_back(mixer->mix(tick));
    return frames;
}

}  // namespace thaum::tactile
