// game/scenario/sandbox.h: a Lua 5.4 state in which a script can only compute.
//
// A script has the same result on every machine and every day. It has no clock, no random numbers, no files
// and no other code. `pairs` visits keys in sorted order, and no address is converted to text. The functions
// of `math` come from core/maths.h. The operator ^ is rejected, because it calls the machine's own pow.
//
// A script always ends. Its steps, memory and processor time are limited. One step is one instruction or 64
// bytes of requested memory, and a function that goes through a text or a list costs its length. Once the
// steps are used up, no pcall and no coroutine can continue. There are no patterns, since Lua's own matcher
// counts no steps: string.find, match, gmatch and gsub raise an error that says so.
//
//     Sandbox sandbox;
//     sandbox.add("answer", [](lua_State* lua, void*) { lua_pushinteger(lua, 42); return 1; }, nullptr);
//     sandbox.start("print(answer()) ", "example.lua");
//     while (sandbox.resume().value() == Sandbox::Progress::waits) { ... }
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"

struct lua_State;

namespace thaum::game::inline scenario {

struct SandboxLimits {
    std::size_t memory = 64U << 20U;    ///< limit of the script's total memory (bytes)
    std::size_t block = 1U << 20U;      ///< largest single string or table part (bytes)
    std::uint64_t steps = 300'000'000;  ///< limit of the steps over the sandbox's whole life
    std::size_t output = 64U << 10U;    ///< limit of the stored `print` output (bytes)
    /// Limit of the script's own processor time (s), without that of the program's functions (verbs) and
    /// waits. It catches work that is not counted as steps, and is so large that no result depends on it.
    double compute_s = 60;
    /// limit of the processor time of all verbs (functions of the program that scripts call) together,
    /// without waits (s)
    double verbs_s = 300;
};

/// A fault thrown by a verb (a function of the program), which becomes a Lua error with the script's file and
/// line in front.
struct ScriptFault {
    std::string message;
};

class Sandbox {
public:
    enum class Progress { waits, done };

    /// A function for scripts. It reads its arguments from the Lua stack, pushes its results, and returns
    /// their number or `wait`. It may throw ScriptFault, but must not call Lua functions or raise Lua errors.
    using Verb = int (*)(lua_State*, void* context);
    /// Result of a verb that stops the script until the next resume. Only the main script can wait, not a
    /// coroutine that it has created.
    static constexpr int wait = -1;

    explicit Sandbox(const SandboxLimits& limits = {});
    ~Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;

    void add(const char* name, Verb verb, void* context);
    /// Runs trusted source that defines functions for the script. An error in such a function is reported at
    /// the script's line that called it.
    Expected<void> run_prelude(std::string_view source);

    /// Loads a script without running it. `name` is used in messages. The error contains the line number.
    Expected<void> start(std::string_view source, std::string_view name);
    /// Runs the script to its next wait or to its end. The error is one line that begins with "NAME:LINE:".
    Expected<Progress> resume();

    /// Text printed by the script, cut off at SandboxLimits::output.
    const std::string& output() const;
    std::uint64_t steps() const;  ///< Number of steps that the script has used so far.
    std::size_t memory() const;   ///< Memory that the script uses now (bytes).
    bool exhausted() const;       ///< Whether the script has used up its steps.

    struct State;

private:
    std::unique_ptr<State> state_;
};

}  // namespace thaum::game::inline scenario
