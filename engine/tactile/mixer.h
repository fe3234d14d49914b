// tactile/mixer.h: makes one frame for the actuators of one device from all effects that play.
//
//     mixer.start(effect, Where::from(direction), strength, tick)      something happened once
//     mixer.drive(key, effect, Where::own(), strength, tick)           something lasts; called for each frame
//     outputs.send(mixer.mix(tick))                                    every frame_ticks
//
// Energies (amplitude squared) of effects add up at an actuator, because their phases are not related.
// So the felt place of several effects is the centroid of their places. A frame then passes three
// limits, in this order: the limit of each actuator, the least gap between two beginnings at one
// actuator, and the limit of all energies.
//
// No event is lost. Two events at one actuator within the gap are merged into the stronger one. If all places
// for effects are taken, an event replaces an effect of lower or equal priority that has been felt, or is
// merged. Every such case is counted.
//
// A mixer has a fixed size, never allocates, and computes the same bits on every machine.
#pragma once
#include "tactile/effect.h"
#include "tactile/frame.h"
#include "tactile/phantom.h"

namespace thaum::tactile {

static_assert(max_actuators == frame_capacity);

inline constexpr std::size_t max_playing = 64;

/// The place at which an effect is felt. An effect with places of its own ignores it.
struct Where {
    /// Way in which the place is given.
    enum class Kind : std::uint8_t { own, on_part, touched, from } kind{};
    BodyPoint point{};
    vec3 direction{};
    double height{};

    /// Names the effect's own places, or the middle of the chest if it has none.
    static Where own() { return {}; }
    /// Names a point of a part (body at rest).
    static Where on(BodyPoint point) { return {Kind::on_part, point, {}, 0}; }
    /// Names a point that something touches (m, body frame, in the current pose).
    static Where touching(vec3 point) { return {Kind::touched, {Part::whole, point}, {}, 0}; }
    /// Names the side of the torso that faces a direction (body frame, from the body to the source), at a
    /// height (m).
    static Where from(vec3 direction, double height = 1.15) { return {Kind::from, {}, direction, height}; }
};

/// Settings of a TactileMixer.
struct MixerSettings {
    double sum_limit{1.5};  ///< largest sum of amplitudes squared; one actuator at full strength has 1
    Tick gap{40};           ///< least time between the beginnings of two effects at one actuator (ticks)
    Tick time_to_live{48};  ///< time to live of a frame (ticks)
    Tick driven_for{24};    ///< time for which an effect lasts after a call of `drive` (ticks)
};

/// Volume settings of the purposes of effects, 0 to 1. Walking is off until the player turns it up.
struct Faders {
    std::array<double, purpose_count> values{1, 1, 1, 0, 1, 1, 1, 1, 1, 1};

    /// Volume fader of the effects of one purpose, such as blasts.
    double& of(Purpose purpose) { return values[static_cast<std::size_t>(purpose)]; }
    double of(Purpose purpose) const { return values[static_cast<std::size_t>(purpose)]; }
    bool operator==(const Faders&) const = default;
};

/// Counts since the beginning. offered = started + merged, so no event is lost.
struct MixerCounts {
    std::uint64_t offered{};  ///< events offered to the mixer by calls of `start`
    std::uint64_t started{};  ///< events that began as effects of their own, because there was room for them
    std::uint64_t merged{};   ///< events merged with another one; the stronger one is felt
    /// Started events that had to wait, because another one had just begun at their actuator.
    std::uint64_t delayed{};
    std::uint64_t replaced{};  ///< effects cut short by one of higher or equal priority
    std::uint64_t clipped{};   ///< values that were not finite or outside of their range
    /// Number of times that an actuator had to wait, because less than `gap` had passed since an effect last
    /// began at it.
    std::uint64_t held{};
    /// Frames whose amplitudes were reduced, because the sum of all energies exceeded its limit.
    std::uint64_t limited{};
    /// Calls of `drive` that were ignored, because there was no room for one more effect.
    std::uint64_t not_driven{};
};

/// Turns running effects into frames for the actuators of one layout.
class TactileMixer {
public:
    /// Keeps references to both arguments `layout` and `bank`. The mixer takes about 170 KB, so allocate it
    /// on the heap.
    TactileMixer(const Layout& layout, const EffectBank& bank, const MixerSettings& settings = {});

    /// Sets the faders from the next frame on. Values outside 0 to 1 are clipped and counted.
    void set_faders(const Faders& faders);
    /// Sets the pose in which touched places lie (Where::touching). A pose that is not finite is counted and
    /// ignored.
    void set_pose(const Pose& pose);
    /// Starts an effect by its number in the bank. `strength` is 0 to 1.
    void start(std::uint32_t effect, const Where& where, double strength, Tick now);
    /// Keeps an effect playing under a key, which must not be 0, and sets its strength. Without further calls
    /// the effect fades out.
    void drive(std::uint32_t key, std::uint32_t effect, const Where& where, double strength, Tick now);
    /// Makes everything silent at once. Must also be called when time jumps.
    void stop();
    /// The frame that begins at `now`. Call it once every frame_ticks.
    const TactileFrame& mix(Tick now);

    /// Number of effects that play or wait to begin.
    std::size_t playing() const { return count_; }
    /// Counts of events, effects and faulty values since the start.
    const MixerCounts& counts() const { return counts_; }

private:
    /// Number of places of a sweep at which the shares of the actuators in the energy are solved. Between two
    /// of these places the shares are interpolated, which moves the centroid along a straight line exactly.
    static constexpr std::size_t max_places = 9;

    struct Playing {
        std::uint32_t effect{};
        /// Key under which `drive` keeps the effect playing; 0: it plays to its end by itself.
        std::uint32_t key{};
        Tick begin{};
        Tick driven_at{};     ///< tick of the last call of `drive`
        double strength{};    ///< strength of the effect, 0 to 1
        double level{};       ///< amplitude of the motors, 0 to 1
        double beat_ms{};     ///< time since the last heartbeat (ms)
        double held_ms{};     ///< time on the envelope at which the decay began (ms); below 0: still held
        Tick released{};      ///< tick at which the hold (the time at full strength) ended
        std::uint8_t main{};  ///< actuator at which the beginning of the effect is strongest
        bool felt{};          ///< true: the effect has been in a frame
        /// Shares of the actuators in the energy (tactile/phantom.h), for each place of the effect. For a
        /// wave that spreads over the skin, the first element holds distances instead (m).
        std::array<Shares, max_places> places{};
    };
    /// Part of an effect's time that a frame covers (ms since the beginning).
    struct Span {
        double from, to;
    };

    const Effect& effect_of(const Playing& playing) const { return bank_->effects[playing.effect]; }
    double checked(double value);
    BodyPoint point_of(const Where& where);
    void place(Playing& playing, const Effect& effect, const Where& where);
    void place_spread(Playing& playing, const BodyPoint& from);
    void place_sweep(Playing& playing, const Effect& effect, const BodyPoint& from);
    Playing* running_at(std::uint8_t actuator, Tick now);
    Playing* free_place(int priority);
    Playing* least_important(bool felt);
    void schedule(Playing& next, Tick now);
    void remove(std::size_t place);

    Span span_of(const Playing& playing, double ms) const;
    void release(Playing& playing, Tick now);
    bool add(Playing& playing, Tick now, double ms);
    bool add_heartbeat(Playing& playing, bool held, double ms);
    void add_shares(const Playing& playing, double amplitude, const Shares& shares);
    void add_spread(const Playing& playing, const Effect& effect, Span span);
    void place_clip(Playing& playing, const Effect& effect);
    void add_clip(const Playing& playing, const Effect& effect, double amplitude, Span span);
    void add_sweep(const Playing& playing, const Effect& effect, double amplitude, double ms);
    void limit(Tick now);
    double pass_gap(std::size_t actuator, double amplitude, Tick now);

    const Layout* layout_;
    const EffectBank* bank_;
    MixerSettings settings_;
    Faders faders_{};
    Pose pose_{};
    MixerCounts counts_{};
    std::array<Playing, max_playing> playing_{};
    /// Indices in `playing_` of the effects that play: the first count_ entries.
    std::array<std::uint8_t, max_playing> order_{};
    std::size_t count_{};
    /// Tick from which another event may begin at an actuator.
    std::array<Tick, max_actuators> free_at_{};
    /// Shares of the actuators in the energy of each cell of a clip (a recording).
    std::array<Shares, clip_cells> clip_shares_{};
    // Sum of the energies (squares of the amplitudes) of all effects in one frame, at each actuator.
    std::array<float, max_actuators> energy_{};
    /// Largest energy of a single effect at each actuator. The effect with this energy gives the actuator's
    /// carrier frequency.
    std::array<float, max_actuators> strongest_{};
    std::array<bool, max_actuators> on_{};
    std::array<Tick, max_actuators> may_begin_{};
    /// Amplitude with which an effect begins at an actuator once the gap since the last beginning there is
    /// over.
    std::array<double, max_actuators> waiting_{};
    bool ringing_{};  ///< true: some actuator is on, or waits to begin
    Tick mixed_at_{};
    bool mixed_{};
    TactileFrame frame_{};
};

/// All frames of one effect on a layout, for files and tests, with all faders at 1.
std::vector<TactileFrame> rendered(const Effect& effect, const Layout& layout, double strength,
                                   const Where& where = Where::own());

}  // namespace thaum::tactile
