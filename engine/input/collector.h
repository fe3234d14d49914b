// input/collector.h: where events meet ticks. The main thread tells what the window system reports, whenever it does;
// the simulation thread takes one sample a tick. Nothing is lost, nothing is counted twice, and neither waits.
#pragma once
#include <atomic>
#include <cstdint>
#include <vector>

#include "input/bindings.h"
#include "input/frame.h"

namespace thaum::input {

/// A pad as it is now; one that is not there is all zero.
struct PadState {
    std::array<double, pad_axes> axes{};  ///< sticks -1..1, right and up positive; triggers 0..1; see PadAxis
    std::uint32_t buttons{};              ///< bit i is PadButton i
};

/// One player's hands. All but `take` belong to one thread, `take` to another.
class HandsCollector {
public:
    explicit HandsCollector(Bindings bindings);

    // Main thread: events. Codes that are not bound are ignored, so every event may go to every collector.
    void key(int code, bool pressed);
    void mouse_button(int code, bool pressed);
    /// Counts, right and down positive (as on a screen); fractions are kept until they make a count.
    void mouse_move(double right, double down);
    /// Steps; away from the user is positive.
    void wheel(double steps);
    void pad(const PadState& state);
    /// Lets go of all that is held, since nobody will tell us when it is let go of.
    void focus_lost();
    /// Changes the bindings; lets go of all that is held.
    void rebind(Bindings bindings);
    /// From now on the mouse counts `gain` times as much (finite, above 0), and up is down with `inverted`: for what is changed
    /// after the DeviceSpec was made, which holds for the whole log.
    void set_look(double gain, bool inverted);

    /// Simulation thread: what came in since the last call. A press shorter than that shows in one sample. Counts
    /// beyond int32 wait for the next sample.
    DeviceSample take();

private:
    std::uint32_t newest_wand(std::uint32_t down);

    struct Bound {
        Action action;
        Control control;
        double strength = 0;  ///< 0..1: how far it is pressed
        bool pressed = false;
    };
    void press(Control::Source source, int code, double strength);
    void set_axis(PadAxis axis, double value);
    void update(Bound& bound, double strength);
    void publish();
    double strength_of(Action action) const;
    bool toggles(Action action) const { return bindings_.toggled[static_cast<std::size_t>(action)]; }
    void flip(std::uint32_t pressed);

    // Main thread.
    Bindings bindings_;
    std::vector<Bound> bound_;
    double right_rest_ = 0, up_rest_ = 0, wheel_rest_ = 0;
    double gain_ = 1, up_sign_ = 1;
    std::uint32_t controls_before_ = 0;  ///< buttons whose controls were held, whatever toggles make of it
    std::uint32_t on_ = 0;               ///< buttons that a toggle holds
    std::uint32_t wands_before_ = 0;     ///< bits of the wands whose keys were down at the last take
    std::uint32_t wand_ = 0;             ///< wand of the last sample
    std::uint32_t held_before_ = 0;

    // Shared. Motion is a sum since the start, so that taking needs no reset that an event could fall into.
    std::atomic<std::int64_t> right_{0}, up_{0}, wheel_{0};
    std::atomic<std::uint64_t> buttons_{0};  ///< low half: held now; high half: pressed since the last take
    std::atomic<std::uint64_t> levels_{0};   ///< five bytes: strafe, forward, turn_right, turn_up, trigger

    // Simulation thread.
    std::int64_t right_taken_ = 0, up_taken_ = 0, wheel_taken_ = 0;
};

}  // namespace thaum::input
