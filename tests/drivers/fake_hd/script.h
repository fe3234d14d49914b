// What $FAKE_HD tells the make-believe library to do: a list of words with commas between them, read at
// hdInitDevice.
//
//     absent, busy, no_permission, no_licence   hdInitDevice fails
//     no_null_name      the arm has a name and only that opens it
//     needs_update      it wants hdUpdateCalibration; manual: only a hand can calibrate it
//     mute              hdGetString says nothing and no limits are told
//     felt              ticks of what follows are counted from the first tick with a force
//     vanish=N          at tick N the arm no longer answers;  warm=N: its motors are too warm
//     name=NAME         of the second arm, whose script is $FAKE_HD_SECOND: the device name that opens it (Right)
//     back=K            after a vanish, a stop or a warm hdInitDevice fails K times, and then all is well
//     nan=N             tick N and the nine after it measure no number
//     late=N            every Nth tick comes 5 ms late;  burst: and what was missed follows at once
//     stop=N            after tick N no more ticks come
//     rate=HZ           its clock is not ours: ticks come so often
//     record=FILE       what the arm exerted and where it was, a line a tick: "fx fy fz x y z" (N, m), written when it is let go of
//     live=FILE         a FakeHdLive, kept up to date while the program lives
//     path=FILE         where the hand wants to be: lines "ms x_mm y_mm z_mm buttons", straight between them
//
// Misbehaviour (modes.h has all of it as a table):
//
//     CALL=HOW          the function CALL misbehaves: blocks, slow (2 s), crashes (SIGSEGV), interrupts (its thread gets SIGTERM),
//                       calls_back (runs the tasks within it), or is an error code in hexadecimal;  from=N: at its Nth call and
//                       all that follow;  until=N: from its Nth call on all is well again
//     hdScheduleAsynchronous=returns_late    its ticks come at once, but it returns after 2 s
//     task=zero         the number that hdScheduleAsynchronous gives is 0
//     crash=N, interrupt=N    from tick N on the library's own thread gets SIGSEGV or SIGTERM between its tasks
//     pose=HOW, turn=HOW    what is measured: nan, inf, huge, stuck, jumps; turn also zero
//     buttons=all       all 32 are down
//     limits=HOW        forces, stiffness, damping: nan, inf, negative, huge, zero
//     box=HOW           the workspace: nan, inverted, huge;  dof=HOW: negative, huge
//     strings=HOW, error_strings=HOW    null, empty, control, invalid, long
//     style=garbage, calibration=garbage, handle=zero|other, errors=endless
//     callback=HOW      never, once, twice (in a tick), two_threads, after_end
//     sync=HOW          hdScheduleSynchronous: never (returns without running the task), late (runs it after it has returned), twice
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/maths.h"

namespace thaum::fake_hd {

struct Place {
    double ms{};
    vec3 target{};  // m
    int buttons{};
};

struct Script {
    std::map<std::string, std::string> words;
    std::vector<Place> path;

    bool has(const char* word) const { return words.contains(word); }
    bool is(const char* word, const char* value) const;
    /// A number; 0 where there is none.
    std::uint64_t number(const char* word) const;
    /// The value of a word; empty where there is none.
    std::string of(const char* word) const;
};

/// Parses words with commas between them.
Script script_of(const std::string& text);
/// Script in $FAKE_HD, and that of the second arm in $FAKE_HD_SECOND.
Script read_script();
Script read_second_script();
Place place_at(const std::vector<Place>& path, double ms);

}  // namespace thaum::fake_hd
