// input/pad_assignment.h: lets the user assign the parts of a joystick that SDL does not know to the controls
// of a pad. It asks for one control after the other, watches which part of the joystick moves, and writes the
// result as a mapping in the form of SDL's gamecontrollerdb.txt:
//
//     GUID,NAME,a:b0,leftx:a0,lefttrigger:a4,dpup:h0.1,platform:Linux,
//
// A part that rests at one end of its range, as triggers do, is treated like a button. No part is assigned
// twice. Both sticks, A, RT and Start cannot be skipped, because a player must be able to move, look, use a
// wand and pause.
#pragma once
#include <optional>
#include <set>

#include "input/pad_state.h"

namespace thaum::input {

/// Asks for each control of an unknown joystick in turn.
class PadAssignment {
public:
    /// Begins with the first control. `stick` must be at rest: no part of it is pressed or moved.
    explicit PadAssignment(const Stick& stick);

    /// Instruction for the user, to be shown on the screen: "press A, the lowest of the four buttons". Empty:
    /// all controls were asked for.
    std::string_view asks() const;
    /// Number of the current question, from 0.
    std::size_t number() const { return number_; }
    /// Number of questions, one for each control of a pad.
    static std::size_t count();

    /// Takes the state of the joystick. Returns whether the current question was answered.
    bool follow(const StickState& current);
    /// Whether the current control is needed, because a duel cannot be played without it.
    bool needs_answer() const;
    /// Skips the current control, unless it is needed.
    void skip();
    /// Names of the controls that were skipped: "B, LT"; empty: none.
    const std::string& skipped() const { return skipped_; }

    /// Whether all controls were asked for and the last part was released.
    bool is_done() const { return asks().empty() && !let_go_first_; }
    /// The mapping with all assigned parts, as a line of SDL's gamecontrollerdb.txt.
    std::string mapping() const;

private:
    std::optional<std::string> moved_part(const StickState& current) const;
    std::optional<std::string> moved_axis(std::size_t axis, int value) const;
    bool is_at_rest(const StickState& current) const;

    std::string guid_, name_;
    StickState rest_;
    std::size_t number_ = 0;
    bool let_go_first_ = false;  ///< true: the last assigned part has not been released yet
    std::string answers_{}, skipped_{};
    std::set<std::string> taken_{};  ///< parts of the joystick that are already assigned, such as "b3"
};

}  // namespace thaum::input
