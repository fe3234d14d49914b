// input/collector.h: turns events of the window system into one sample per tick. The main thread reports
// events at any time. The simulation thread takes the samples. No event is lost or counted twice, and neither
// thread waits.
#pragma once
#include <atomic>
#include <cstdint>
#include <vector>

#include "input/bindings.h"
#include "input/frame.h"
#include "input/pad_state.h"
#include "input/stick.h"

namespace thaum::input {

/// Input of one player's hands. One thread calls `take`, another thread all other functions.
class HandsCollector {
public:
    explicit HandsCollector(Bindings bindings);

    /// A key went down or up. The main thread reports all events. Unbound codes are ignored, so every event
    /// may be reported to every collector.
    void key(int code, bool pressed);
    /// A mouse button went down or up.
    void mouse_button(int code, bool pressed);
    /// Adds mouse counts, positive to the right and down (as on a screen). Fractions are kept until they make
    /// a whole count.
    void mouse_move(double right, double down);
    /// Adds wheel steps; away from the user is positive.
    void wheel(double steps);
    /// Takes the newest state of a game pad, which replaces the one before.
    void pad(const PadState& state);
    /// Releases all held controls, because their release will not be reported.
    void focus_lost();
    /// Changes the bindings and releases all held controls.
    void rebind(Bindings bindings);
    /// Multiplies later mouse counts by `gain` (finite, above 0), and exchanges up and down if `inverted`.
    /// Used for changes during a match, because the settings of a device in the log's header (DeviceSpec)
    /// hold for the whole match.
    void set_look(double gain, bool inverted);

    /// Sets the time over which a turn of the view by keys or a stick grows to its full speed (s, at least
    /// 0), so that a short press turns only a little. 0: at once.
    void set_turn_ramp(double seconds);

    /// Sets dead zone and response curve of the sticks, from their next position on.
    void set_sticks(const StickResponse& sticks);

    /// The input since the last call; called by the simulation thread. A press and release between two calls
    /// still shows in one sample. Counts beyond int32 are kept for the next sample.
    DeviceSample take();

private:
    std::uint8_t newest_wand(std::uint32_t down);

    struct Bound {
        Action action;
        Control control;
        double strength = 0;  ///< how far the control is pressed, 0..1
        bool pressed = false;
    };
    void press(Control::Source source, int code, double strength);
    void set_axis(PadAxis axis, double value);
    void update(Bound& bound, double strength);
    void publish();
    double strength_of(Action action) const;
    int wheel_direction() const;
    std::int32_t held_wheel(std::int32_t way);
    bool toggles(Action action) const { return bindings_.toggled[static_cast<std::size_t>(action)]; }
    void flip(std::uint32_t pressed);

    // The next members are used by the main thread.
    Bindings bindings_;
    std::vector<Bound> bound_;
    double right_rest_ = 0, up_rest_ = 0, wheel_rest_ = 0;
    double gain_ = 1, up_sign_ = 1;
    StickResponse sticks_;
    /// Buttons whose controls were held when `publish` last passed the buttons to the simulation thread,
    /// whatever toggled actions were on.
    std::uint32_t controls_before_ = 0;
    std::uint32_t on_ = 0;  ///< buttons of the toggled actions that are on, though their controls may be up
    std::uint32_t wands_before_ = 0;  ///< bits of the wands whose keys were down in the last sample
    std::uint8_t wand_ = 0;           ///< number of the wand in the last sample; 0: none
    std::uint32_t held_before_ = 0;
    int wheel_way_before_ = 0;  ///< direction of the wheel when `publish` was last called

    // Shared by both threads. Motion is a sum since the start, so `take` needs no reset, during which an
    // event could be lost.
    std::atomic<std::int64_t> right_{0}, up_{0}, wheel_{0};
    /// Button bits: in the low half those held now, in the high half those pressed since the last `take`.
    std::atomic<std::uint64_t> buttons_{0};
    /// Six levels (how far controls are pressed) of one byte each: strafe, forward, turn_right, turn_up,
    /// trigger, direction of the wheel.
    std::atomic<std::uint64_t> levels_{0};

    std::atomic<std::uint32_t> ramp_ticks_{0};  ///< length of the slow start of a turn of the view (ticks)

    /// A turn of the view about one axis by keys or a stick.
    struct Turn {
        std::uint32_t ticks = 0;  ///< age of the turn, counted up to the length of its slow start (ticks)
        bool positive = false;    ///< true: the turn goes to the right or upwards
    };
    std::int32_t ramped(std::int32_t level, Turn& turn) const;

    // The next members are used by the simulation thread.
    Turn turn_right_, turn_up_;
    std::int64_t right_taken_ = 0, up_taken_ = 0, wheel_taken_ = 0;
    double wheel_held_ = 0;             ///< share of its next wheel step that a held control has collected
    std::int32_t wheel_way_taken_ = 0;  ///< direction of the wheel in the last sample
};

}  // namespace thaum::input
