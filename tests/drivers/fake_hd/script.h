// tests/drivers/fake_hd/script.h: the script of the fake library: a list of words separated by commas in
// $FAKE_HD, read at hdInitDevice.
//
//     absent, busy, no_permission, no_licence   hdInitDevice fails
//     no_null_name      only the arm's name opens it; a null name does not
//     needs_update      the arm needs hdUpdateCalibration;  manual: only a person can calibrate it
//     mute              hdGetString returns nothing, and all limits are 0
//     felt              the numbers of ticks below count from the first tick with a force
//     vanish=N          from tick N on the arm does not answer;  warm=N: its motors are too warm
//     name=NAME         name that opens the second arm (default Right), whose script is $FAKE_HD_SECOND
//     back=K            after vanish, stop or warm, hdInitDevice fails K times, then all is well
//     nan=N             ten ticks from N on measure no number
//     late=N            every Nth tick comes 5 ms late;  burst: the missed ticks follow at once
//     stop=N            no tick comes after tick N
//     rate=HZ           rate of the library's ticks
//     record=FILE       force of the arm and position of its tip, one line per tick: "fx fy fz x y z"
//                       (N, m); written when the device is released
//     live=FILE         the arm's forces as a FakeHdLive, kept up to date while the program runs
//     path=FILE         target of the simulated hand: lines "ms x_mm y_mm z_mm buttons", with straight
//                       lines between the points
//
// Faults (modes.h has a table of all that are tested):
//
//     CALL=HOW          the function CALL blocks, is slow (2 s), crashes (SIGSEGV), interrupts (its thread
//                       gets SIGTERM), calls_back (runs the tasks inside the call), or fails with an error
//                       code in hexadecimal
//     from=N, until=N   the first call with the fault, and the first call without it again
//     hdScheduleAsynchronous=returns_late    ticks come at once, but the function returns after 2 s
//     task=zero         hdScheduleAsynchronous returns 0 as the number of the task
//     crash=N, interrupt=N    from tick N on the library's thread gets SIGSEGV or SIGTERM between tasks
//     pose=HOW, turn=HOW    measured position and rotation: nan, inf, huge, stuck, jumps; turn also zero
//     buttons=all       all 32 buttons are down
//     limits=HOW        limits of force, stiffness and damping: nan, inf, negative, huge, zero
//     box=HOW           the workspace: nan, inverted, huge;  dof=HOW: negative, huge
//     strings=HOW, error_strings=HOW    null, empty, control, invalid, long
//     style=garbage, calibration=garbage, handle=zero|other, errors=endless
//     callback=HOW      tasks are called never, once, twice (in a tick), by two_threads, or after_end
//     sync=HOW          hdScheduleSynchronous never runs the task, runs it late (after it has returned),
//                       or twice
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/maths.h"

namespace thaum::fake_hd {

struct Place {
    double ms{};
    // target position of the simulated hand (m)
    vec3 target{};
    int buttons{};
};

struct Script {
    std::map<std::string, std::string> words;
    std::vector<Place> path;

    bool has(const char* word) const { return words.contains(word); }
    bool is(const char* word, const char* value) const;
    /// Number given for an option; 0 if the script lacks it.
    std::uint64_t number(const char* word) const;
    /// Value given for an option; empty if the script lacks it.
    std::string of(const char* word) const;
};

/// Parses options separated by commas.
Script script_of(const std::string& text);
/// Reads the script in $FAKE_HD, and that of the second arm in $FAKE_HD_SECOND.
Script read_script();
Script read_second_script();
Place place_at(const std::vector<Place>& path, double ms);

}  // namespace thaum::fake_hd
