// tests/drivers/fake_hd/library.h: state of the fake library: a simulated arm in a simulated hand, the
// checked rules, and the library's clock.
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

constexpr unsigned int only_handle = 7, no_handle = 0xffffffff;
constexpr double max_force = 3.3;  // largest force of the arm (N)
// Force that only a wrong unit explains, such as mN, or a stiffness in N/m (N).
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

struct Library {
    std::mutex mutex{};  // guards all members below, except while a task runs
    Script script = read_script();
    haptics::SimulatedDevice device{};
    haptics::SimulatedState arm{};
    bool initiated = false, frame = false, force_output = false, clamping = false, updated = false;
    vec3 told{};  // force set by the last frame that ended (N)
    vec3 setting{};
    std::vector<unsigned int> errors{};
    std::vector<Task> tasks{};
    Task newest_ticks{};  // asynchronous task that was scheduled last
    unsigned long next_task = 1;
    FakeHdReport report{};
    FakeHdLive* live = nullptr;  // mapped file of the word `live`; never unmapped
    std::vector<std::array<double, 6>> recorded{};
    std::map<std::string, std::uint64_t> calls{};  // number of calls of each misbehaving function
    int buttons = 0;
    bool went_wrong = false, came_back = false;
    std::uint64_t refused = 0;
    std::uint64_t felt_at = 0;  // tick of the first force; 0: none yet

    std::jthread thread{}, second_thread{};
    std::atomic<bool> running{false};
    std::atomic<std::thread::id> own_thread{};
};

/// The state of the library. It is never destroyed, because threads of a program that gave up may still use
/// it.
Library& library();

using Lock = std::unique_lock<std::mutex>;

// Call these with the mutex locked.

void push(Library& l, unsigned int code);
/// Counts a broken rule and adds an error with this code to the error stack.
void broken(Library& l, FakeHdRule rule, unsigned int code);
bool on_own_thread(const Library& l);
/// Returns true if state may be read or set now.
bool may(Library& l);

/// Gives the device to a program.
void take_device(Library& l);
/// Takes the device back from the program.
void let_go(Library& l);
/// Force that the arm exerts now (N).
vec3 exerted(const Library& l);
/// Simulates one tick of the arm (1 ms).
void move_arm(Library& l);
void update_live(Library& l);
/// Returns true if the fault named by `word` is due. An arm that has come back has no further fault.
bool goes_wrong(Library& l, const char* word);
/// Returns true while an arm that went wrong is absent.
bool is_missing(Library& l);

// Call these with the mutex unlocked.

unsigned long schedule(Library& l, Callback run, void* context, unsigned short priority, bool synchronous);
void start_threads(Library& l);
void stop_threads(Library& l);
/// Runs every task once. `synchronous_only` leaves out tasks of hdScheduleAsynchronous.
void run_tasks(Library& l, bool synchronous_only);
/// Calls the last task of hdScheduleAsynchronous once more, even if the program has already ended it.
void call_ticks(Library& l);
/// Repeats call_ticks on a thread of its own.
void call_after_end(Library& l);

}  // namespace thaum::fake_hd
