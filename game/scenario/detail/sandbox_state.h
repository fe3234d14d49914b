// game/scenario/detail/sandbox_state.h: what the sandbox and its library share.
//
// Lua is C: an error jumps over our frames without destroying anything. So a function that may raise one holds nothing that
// needs to be destroyed while it calls Lua.
#pragma once
#include <limits>
#include <lua.hpp>
#include <optional>

#include "game/scenario/sandbox.h"

namespace thaum::game {

inline constexpr const char* prelude_name = "=prelude";

struct Sandbox::State {
    SandboxLimits limits;
    lua_State* lua = nullptr;     ///< the main state; no script runs in it, but the prelude
    lua_State* script = nullptr;  ///< the script's coroutine, while there is one
    std::size_t memory = 0;
    std::uint64_t steps = 0;
    bool trusted = false;    ///< our own code runs, which no allocation may interrupt
    bool exhausted = false;  ///< from now on every error passes through all pcalls
    bool late = false;       ///< exhausted by the wall clock
    std::int64_t deadline_ns =
        std::numeric_limits<std::int64_t>::max();  ///< monotonic clock, while a script runs
    std::int64_t computed_ns = 0;                  ///< time that the script has computed before
    std::string name;                              ///< of the script
    std::string output;
    std::string fault;  ///< of the verb that has just failed

    /// Counts; false, and for good, when there are none left.
    bool spend(std::uint64_t count) {
        steps += count;
        exhausted = exhausted || steps > limits.steps;
        return !exhausted;
    }
};

inline Sandbox::State& state_of(lua_State* lua) {
    return **static_cast<Sandbox::State**>(lua_getextraspace(lua));
}

/// Raises "NAME:LINE: message" with the line of the innermost function of the script (not of the prelude); the message
/// is on top of the stack.
int raise_at_script(lua_State* lua);

/// The safe parts of Lua's libraries, and our own in place of the others.
void open_library(lua_State* lua);

/// Puts find, match, gmatch and gsub, whose work is counted, into the table on top of the stack.
void set_matching(lua_State* lua);

/// Line of the first operator ^ in a source, if there is one.
std::optional<int> line_of_power(std::string_view source);

}  // namespace thaum::game
