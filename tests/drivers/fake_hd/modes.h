// tests/drivers/fake_hd/modes.h: every fault of the fake library that tests try, and the required result for
// a program that holds a force of 1 N meanwhile. script.h explains the options.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace thaum::fake_hd {

enum class Ending {
    plays,    ///< the program continues to play
    lost,     ///< the program reports in one line that the arm is lost or faulty
    refused,  ///< the program reports in one line that there is no usable arm
};

struct Mode {
    std::string words;
    Ending wanted{};
};

/// Results if a function always fails, and if it never returns.
struct CallRow {
    const char* call;
    Ending fails, blocks;
    const char* with = "";  ///< further options of the script, without which the function is not called
};

/// Functions of the library that fail or never return, from their first call on.
inline constexpr auto calls_that_never_work = [] {
    using enum Ending;
    return std::to_array<CallRow>({
        {"hdInitDevice", refused, refused},
        {"hdDisableDevice", plays, plays},
        {"hdMakeCurrentDevice", refused, refused},
        {"hdBeginFrame", refused, refused},
        {"hdEndFrame", refused, refused},
        {"hdGetIntegerv", lost, refused},
        {"hdGetDoublev", refused, refused},
        {"hdSetDoublev", lost, lost},
        {"hdGetString", plays, refused},
        {"hdEnable", refused, refused},
        {"hdGetErrorString", refused, refused, ",absent"},
        {"hdStartScheduler", refused, refused},
        {"hdStopScheduler", plays, plays},
        {"hdSetSchedulerRate", refused, refused},
        {"hdScheduleSynchronous", refused, refused},
        {"hdScheduleAsynchronous", refused, refused},
        {"hdUnschedule", lost, lost, ",stop=100"},
        {"hdCheckCalibration", refused, refused},
        {"hdCheckCalibrationStyle", refused, refused, ",needs_update"},
        {"hdUpdateCalibration", refused, refused, ",needs_update"},
    });
}();

inline std::vector<Mode> modes_of_calls() {
    using enum Ending;
    std::vector<Mode> modes;
    for (const auto& row : calls_that_never_work) {
        modes.push_back({std::string(row.call) + "=0302" + row.with, row.fails});
        modes.push_back({std::string(row.call) + "=blocks" + row.with, row.blocks});
    }
    modes.push_back({"hdGetError=blocks", refused});
    for (const char* call : {"hdBeginFrame", "hdEndFrame", "hdGetIntegerv", "hdGetDoublev", "hdSetDoublev"}) {
        modes.push_back({std::string(call) + "=0302,from=200", lost});
        modes.push_back({std::string(call) + "=0200,from=200", lost});
        modes.push_back({std::string(call) + "=0302,from=200,until=201", lost});
        modes.push_back({std::string(call) + "=blocks,from=200", lost});
        modes.push_back({std::string(call) + "=calls_back,from=20", plays});
    }
    modes.push_back({"hdGetError=blocks,from=200", lost});
    modes.push_back({"hdGetErrorString=blocks,vanish=100", lost});
    modes.push_back({"hdInitDevice=slow", refused});
    modes.push_back({"hdStartScheduler=slow", refused});
    modes.push_back({"hdScheduleAsynchronous=slow", refused});
    modes.push_back({"hdScheduleAsynchronous=returns_late", refused});
    modes.push_back({"hdStopScheduler=slow", plays});
    return modes;
}

/// Faults in measured values, texts, limits and ticks, independent of the function that returns them.
inline std::vector<Mode> modes_of_answers() {
    using enum Ending;
    std::vector<Mode> modes;
    const auto add = [&](const char* word, std::initializer_list<const char*> hows, Ending wanted,
                         const char* with = "") {
        for (const char* how : hows) modes.push_back({std::string(word) + "=" + how + with, wanted});
    };
    add("pose", {"nan", "inf", "huge", "stuck", "jumps"}, plays);
    add("turn", {"nan", "inf", "huge", "zero", "jumps"}, plays);
    add("buttons", {"all"}, plays);
    add("limits", {"nan", "inf", "negative", "huge", "zero"}, refused);
    add("box", {"nan", "inverted", "huge"}, plays);
    add("dof", {"negative", "huge"}, plays);
    add("strings", {"null", "empty", "control", "invalid", "long"}, plays);
    add("error_strings", {"null", "empty", "control", "invalid", "long"}, refused, ",absent");
    add("error_strings", {"null", "empty", "control", "invalid", "long"}, lost, ",felt,warm=100");
    add("style", {"garbage"}, refused, ",needs_update");
    add("calibration", {"garbage"}, refused);
    add("handle", {"zero", "other"}, plays);
    add("errors", {"endless"}, refused);
    add("callback", {"never", "once"}, lost);
    add("callback", {"twice", "two_threads", "after_end"}, plays);
    add("sync", {"never", "late", "twice"}, refused);
    add("task", {"zero"}, plays);
    add("rate", {"100", "500", "2000"}, plays);
    add("hdInitDevice", {"0300", "0301", "0303", "0304", "0600", "ffff"}, refused);
    for (const char* word : {"absent", "busy", "no_permission", "no_licence", "manual", "mute"})
        modes.push_back({word, refused});
    for (const char* word : {"felt,vanish=100", "felt,warm=100", "felt,stop=100", "stop=1"})
        modes.push_back({word, lost});
    for (const char* word : {"late=20", "late=20,burst", "nan=100", "no_null_name", "needs_update"})
        modes.push_back({word, plays});
    return modes;
}

}  // namespace thaum::fake_hd
