// game/scenario/detail/sandbox_state.h: state shared by the sandbox and its library.
//
// Lua is C, so an error jumps over C++ frames without running destructors. A function that can raise an error
// therefore holds no object with a destructor while it calls Lua.
#pragma once
#include <limits>
#include <lua.hpp>
#include <optional>

#include "game/scenario/sandbox.h"

namespace thaum::game::inline scenario {

inline constexpr const char* prelude_name = "=prelude";

struct Sandbox::State {
    SandboxLimits limits;
    /// main state of Lua; only the prelude, trusted Lua code of the program, runs in it
    lua_State* lua = nullptr;
    lua_State* script = nullptr;  ///< coroutine of the script, if one is loaded
    std::size_t memory = 0;
    std::uint64_t steps = 0;
    bool trusted = false;    ///< true: trusted code is running, which no failing allocation may interrupt
    bool exhausted = false;  ///< true: steps or time are used up, and every error passes through all pcalls
    bool late = false;       ///< true: the processor time is used up
    /// Thread processor time at which the script must have ended (ns). It is far in the future while no
    /// script runs.
    std::int64_t deadline_ns = std::numeric_limits<std::int64_t>::max() / 2;
    std::int64_t computed_ns = 0;  ///< processor time that the script has used before the present resume (ns)
    std::int64_t verbs_ns = 0;     ///< processor time used by verbs, the functions of the program (ns)
    std::string name;              ///< name of the script
    std::string output;
    std::string fault;  ///< message of the verb that has just failed

    /// Adds to the steps, of instructions and memory, that the script has used. Returns false once the limit
    /// is reached.
    bool spend(std::uint64_t count) {
        steps += count;
        exhausted = exhausted || steps > limits.steps;
        return !exhausted;
    }
};

inline Sandbox::State& state_of(lua_State* lua) {
    return **static_cast<Sandbox::State**>(lua_getextraspace(lua));
}

/// Number of instructions between two checks of steps and time.
inline constexpr int hook_steps = 1000;

/// Adds to the steps, of instructions and memory, that the script has used. Raises an error that no pcall
/// catches once the steps or the processor time are used up.
void charge(lua_State* lua, std::uint64_t steps);

/// Raises "NAME:LINE: message" with the line of the script's innermost function, not of the prelude (the
/// program's own Lua code). The message is on top of the stack.
int raise_at_script(lua_State* lua);

/// Adds the safe parts of Lua's libraries, and replacements for the others.
void open_library(lua_State* lua);

/// Line of the first operator ^ in a source; std::nullopt if there is none.
std::optional<int> line_of_power(std::string_view source);

}  // namespace thaum::game::inline scenario
