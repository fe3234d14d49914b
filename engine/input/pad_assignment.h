// input/pad_assignment.h: makes a pad of a joystick that SDL does not know. It asks for one control of a pad after the
// other, watches which part of the joystick moves, and writes the answers as a mapping in the form of SDL's
// gamecontrollerdb.txt:
//
//     GUID,NAME,a:b0,leftx:a0,lefttrigger:a4,dpup:h0.1,platform:Linux,
//
// A part that rests at one end of its way, as triggers do, is asked for like a button. No part answers twice. Both sticks,
// A, RT and Start cannot be left out: who cannot move, look, use a wand or pause cannot play.
#pragma once
#include <optional>
#include <set>

#include "input/pad_state.h"

namespace thaum::input {

class PadAssignment {
public:
    /// Nobody touches the joystick at this moment.
    explicit PadAssignment(const Stick& stick);

    /// What to do next, in words for the screen: "press A, the lowest of the four buttons". Empty: all was asked for.
    std::string_view asks() const;
    /// Number of the present question, from 0, and how many there are.
    std::size_t number() const { return number_; }
    static std::size_t count();

    /// Looks at the joystick. Returns whether the present question was answered.
    bool follow(const StickState& now);
    /// Whether a duel cannot be played without the present control.
    bool needs_answer() const;
    /// Leaves the present control out, unless it is needed.
    void skip();
    /// Names of the controls that were left out: "B, LT"; empty: none.
    const std::string& skipped() const { return skipped_; }

    /// Whether all was asked for, and the part of the last answer was let go of.
    bool is_done() const { return asks().empty() && !let_go_first_; }
    /// The mapping of all answers.
    std::string mapping() const;

private:
    std::optional<std::string> moved_part(const StickState& now) const;
    std::optional<std::string> moved_axis(std::size_t axis, int value) const;
    bool is_at_rest(const StickState& now) const;

    std::string guid_, name_;
    StickState rest_;
    std::size_t number_ = 0;
    bool let_go_first_ = false;  ///< the part of the last answer is still held
    std::string answers_{}, skipped_{};
    std::set<std::string> taken_{};  ///< parts that have answered
};

}  // namespace thaum::input
