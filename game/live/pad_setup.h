// game/live/pad_setup.h: joysticks that are plugged in but cannot be used. Tells why, and sets up one that
// SDL does not know as a pad: the menu asks for one control after the other (input/pad_assignment.h).
#pragma once
#include <set>

#include "game/live/menu.h"
#include "input/locked_sticks.h"
#include "input/pad_assignment.h"

namespace thaum::game::inline live {

/// Joysticks that cannot be used, and pads that were set up by hand.
struct IdleSticks {
    std::vector<input::Stick> unknown{};       ///< joysticks that SDL does not know
    std::vector<input::Stick> own{};           ///< pads that were set up by hand
    std::vector<input::LockedStick> locked{};  ///< joysticks that this user may not read
    std::vector<std::string> left_over{};      ///< names of pads beyond the number that can play
    /// names of pads without a right stick, which turns a player by default
    std::vector<std::string> without_right_stick{};
    std::vector<std::string> faults{};  ///< faults of SDL, and of the file of mappings
};

/// A change of the SDL mapping of one model of joystick.
struct PadChange {
    std::string model{};
    std::string mapping{};  ///< the new mapping; empty: the mapping that the user made is forgotten
};

/// One line for each joystick that cannot be used, with what to do about it.
std::vector<std::string> faults_of(const IdleSticks& sticks);

/// Advice how a user gets the right to read all joysticks.
inline constexpr std::string_view how_to_unlock =
    "add to /etc/udev/rules.d/60-thaum.rules: SUBSYSTEM==\"input\", ENV{ID_INPUT_JOYSTICK}==\"1\", "
    "TAG+=\"uaccess\"; then plug it in again";

class PadSetup {
public:
    /// `file` receives the mappings; empty: they last for this run only.
    explicit PadSetup(std::filesystem::path file) : file_(std::move(file)) {}

    /// Carries out a request of the menu if it is about the set-up of a joystick. Returns whether it was.
    bool carry_out(MenuRequest request, const LiveMenu& menu);
    /// Looks at the joysticks, and tells the menu about them. Returns a change once all controls were asked
    /// for, or if a set-up is to be forgotten.
    std::optional<PadChange> follow(IdleSticks sticks, LiveMenu& menu);
    /// Ends a change: keeps a mapping that SDL has accepted (`taken`), or tells why SDL has not.
    void end(const PadChange& change, const Expected<void>& taken, LiveMenu& menu);

    /// The states of the pads, without any input of a pad that is being set up again: its old buttons must
    /// not act meanwhile.
    Pads without_stick(Pads pads) const;

private:
    const input::Stick* stick_of(std::size_t number) const;
    const input::Stick* present_stick() const;
    std::string words_of_end(const PadChange& change) const;
    void tell_faults(LiveMenu& menu);
    void ask(LiveMenu& menu);

    std::filesystem::path file_;
    IdleSticks sticks_{};
    std::string model_{}, path_{};  ///< guid and device file of the joystick that is set up
    std::optional<input::PadAssignment> assignment_{};
    std::string skipped_{};  ///< controls that the last set-up left out
    /// removal of a pad's SDL mapping that the user wants; the next follow() returns it
    std::optional<PadChange> due_{};
    std::string asked_{};           ///< the question that was asked last
    std::set<std::string> told_{};  ///< faults that the terminal has shown
};

}  // namespace thaum::game::inline live
