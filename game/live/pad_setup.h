// game/live/pad_setup.h: joysticks that are plugged in and do not play. Tells why, and makes a pad of one that SDL does
// not know: the menu asks for one control after the other (input/pad_assignment.h).
#pragma once
#include <set>

#include "game/live/live_menu.h"
#include "input/locked_sticks.h"
#include "input/pad_assignment.h"

namespace thaum::app {

/// Joysticks that do not play.
struct IdleSticks {
    std::vector<input::Stick> unknown{};       ///< those that SDL does not know
    std::vector<input::LockedStick> locked{};  ///< those that this user may not read
    std::string fault{};                       ///< fault of SDL, or of a mapping; empty: none
};

/// One line for each joystick that does not play, with what to do about it.
std::vector<std::string> faults_of(const IdleSticks& sticks);

/// How a user is allowed to read all joysticks.
inline constexpr std::string_view how_to_unlock =
    "add to /etc/udev/rules.d/60-thaum.rules: SUBSYSTEM==\"input\", ENV{ID_INPUT_JOYSTICK}==\"1\", "
    "TAG+=\"uaccess\"; then plug it in again";

class PadSetup {
public:
    /// `file` receives the mappings; empty: they last for this run only.
    explicit PadSetup(std::filesystem::path file) : file_(std::move(file)) {}

    /// Carries out a request of the menu. Returns whether it was one about the set-up.
    bool carry_out(MenuRequest request, const LiveMenu& menu);
    /// Looks at the joysticks, and tells the menu about them. Returns the mapping once all controls were asked for.
    std::optional<std::string> follow(IdleSticks sticks, LiveMenu& menu);
    /// Ends the set-up: keeps a mapping that SDL has taken, or tells why it has not.
    void end(const std::string& mapping, const Expected<void>& taken, LiveMenu& menu) const;

private:
    void tell_faults(LiveMenu& menu);
    void ask(std::string question, LiveMenu& menu);

    std::filesystem::path file_;
    IdleSticks sticks_{};
    std::string model_{};  ///< guid of the joystick that is set up
    std::optional<input::PadAssignment> assignment_{};
    std::string asked_{};           ///< the present question
    std::set<std::string> told_{};  ///< faults that the terminal has shown
};

}  // namespace thaum::app
