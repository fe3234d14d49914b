// The fake library itself: two simulated arms in simulated hands, the rules that the library checks, and its
// clock.
#pragma once
#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "drivers/fake_hd/fake_hd.h"
#include "drivers/fake_hd/script.h"
#include "haptics/simulated.h"

namespace thaum::fake_hd {

using Callback = unsigned int (*)(void*);

constexpr unsigned int first_handle = 7, second_handle = 8, no_handle = 0xffffffff;
constexpr double max_force = 3.3;  // peak force of an arm (N)
// Smallest force (N) that must be a mistake of the unit, such as mN for N.
constexpr double absurd_force = 100;

enum Error : unsigned int {
    invalid_enum = 0x0100,
    invalid_value = 0x0101,
    invalid_operation = 0x0102,
    bad_handle = 0x0104,
    warm_motors = 0x0200,
    exceeded_max_force = 0x0201,
    already_initiated = 0x0301,
    comm_error = 0x0302,
    illegal_begin = 0x0400,
    illegal_end = 0x0401,
    frame_error = 0x0402,
    invalid_priority = 0x0500,
    invalid_licence = 0x0600,
};

struct Task {
    unsigned long number;
    unsigned short priority;
    Callback run;
    void* context;
    bool synchronous;
};

/// One arm that is plugged in.
struct Device {
    unsigned int handle{};
    Script script{};
    haptics::SimulatedDevice device{};
    haptics::SimulatedState arm{};
    bool initiated = false, frame = false, force_output = false, clamping = false, updated = false;
    vec3 told{};     ///< force that the program set in the last completed frame (N)
    vec3 setting{};  ///< force that the program has set in the open frame (N)
    std::uint64_t ticks = 0;
    FakeHdReport report{};       ///< what tests may ask: force, largest force, position, last force
    FakeHdLive* live = nullptr;  ///< file for tests, mapped into memory and never unmapped
    std::vector<std::array<double, 6>> recorded{};
    int buttons = 0;
    bool went_wrong = false, came_back = false;
    std::uint64_t refused = 0;
    std::uint64_t felt_at = 0;  ///< tick of the first force; 0: none yet
};

struct Library {
    std::mutex mutex{};               // protects the members down to `calls`; not locked while a task runs
    Script script = read_script();    // script of the first arm, and options of the library
    std::array<Device, 2> devices{};  // the second arm exists if $FAKE_HD_SECOND is set
    std::size_t current = 0;          // index of the current device
    std::vector<unsigned int> errors{};
    std::vector<Task> tasks{};
    Task newest_ticks{};  // asynchronous task that the program has scheduled last
    unsigned long next_task = 1;
    FakeHdReport report{};  // the library's ticks, violations, calls after the end, and stops
    std::map<std::string, std::uint64_t> calls{};  // number of calls of each function with a scripted fault

    std::jthread thread{}, second_thread{};
    std::atomic<bool> running{false};
    std::atomic<std::thread::id> own_thread{};
};

/// The state of the library. It is never destroyed, because threads that a program has abandoned may still
/// use it.
Library& library();

using Lock = std::unique_lock<std::mutex>;

// The functions below need the mutex to be locked.

void push(Library& l, unsigned int code);
/// Counts a violation and adds an error with this code to the error stack.
void broken(Library& l, FakeHdRule rule, unsigned int code);
bool on_own_thread(const Library& l);
/// Whether the caller may read or set the state of the current device now: whether it is inside a frame and
/// in the right thread.
bool may(Library& l);

Device& current(Library& l);
/// Must be called when a program opens the device. Resets its state.
void take_device(Library& l, Device& d);
/// Must be called when the program closes the device. Records its last force.
void let_go(Device& d);
/// Force that the arm exerts now (N).
vec3 exerted(const Device& d);
/// Moves every opened arm by 1 ms.
void move_arms(Library& l);
void update_live(Device& d);
/// Whether the scripted fault `word` is due now. For an arm that comes back, each fault happens once.
bool goes_wrong(Device& d, const char* word);
/// Whether a fault has made the arm unavailable.
bool is_missing(Device& d);

// The functions below need the mutex to be unlocked.

unsigned long schedule(Library& l, Callback run, void* context, unsigned short priority, bool synchronous);
void start_threads(Library& l);
void stop_threads(Library& l);
/// Runs every task once. `synchronous_only` skips tasks of hdScheduleAsynchronous.
void run_tasks(Library& l, bool synchronous_only);
/// Calls the newest task of hdScheduleAsynchronous, which computes a tick of the program, once more, even if
/// the program has already ended that task.
void call_ticks(Library& l);
/// Repeats call_ticks in a thread of its own, to simulate a library that calls tasks after their end.
void call_after_end(Library& l);

}  // namespace thaum::fake_hd
