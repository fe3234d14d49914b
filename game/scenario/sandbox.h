// game/scenario/sandbox.h: a Lua 5.4 state in which a script can compute, and nothing else.
//
// The same script does the same on every machine and every day: no clock, no random numbers, no files, no other code;
// `pairs` goes by sorted keys; no address ever becomes text; the functions of `math` are those of core/maths.h, and the
// operator ^, which calls the machine's own pow, is refused. And it always comes to an end: it may spend so many steps (one for
// an instruction, one for every 64 bytes asked for, one for every byte that a pattern is compared with), so much memory
// and so much time, and when the steps are spent no pcall and no coroutine keeps it alive.
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

namespace thaum::game {

struct SandboxLimits {
    std::size_t memory = 64U << 20U;    ///< bytes, all together
    std::size_t block = 1U << 20U;      ///< bytes, of one string or table part
    std::uint64_t steps = 300'000'000;  ///< in the sandbox's whole life
    std::size_t output = 64U << 10U;    ///< bytes of `print` that are kept
    /// Time for which a script may compute, verbs and waits left out (s). It guards against work that no step counts,
    /// and is so generous that no result depends on it.
    double wall_s = 60;
};

/// Thrown by a verb: becomes a Lua error with the script's file and line in front.
struct ScriptFault {
    std::string message;
};

class Sandbox {
public:
    enum class Progress { waits, done };

    /// A function for scripts. It reads its arguments from the stack, pushes its results and returns their number, or
    /// `wait`. It may throw ScriptFault, and must neither call Lua functions nor raise Lua errors.
    using Verb = int (*)(lua_State*, void* context);
    /// Returned by a verb: the script stops here until the next resume. Only for the script itself, not for a
    /// coroutine that it made.
    static constexpr int wait = -1;

    explicit Sandbox(const SandboxLimits& limits = {});
    ~Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;

    void add(const char* name, Verb verb, void* context);
    /// Runs source of ours, which may define functions for the script. Errors in them are reported at the script's line
    /// that called them.
    Expected<void> run_prelude(std::string_view source);

    /// Takes a script; nothing runs yet. The name stands in messages. The error has the line.
    Expected<void> start(std::string_view source, std::string_view name);
    /// Runs on to the next wait or the end. The error is one line that begins with "NAME:LINE:".
    Expected<Progress> resume();

    /// What the script printed, at most SandboxLimits::output.
    const std::string& output() const;
    std::uint64_t steps() const;  ///< spent so far
    std::size_t memory() const;   ///< bytes in use
    bool exhausted() const;       ///< the steps are spent

    struct State;

private:
    std::unique_ptr<State> state_;
};

}  // namespace thaum::game
