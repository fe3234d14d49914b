// game/scenario/detail/arguments.h: reads the arguments of verbs (the functions of scenario scripts) from
// Lua's stack. A wrong argument throws a ScriptFault that names it. No function here calls metamethods or
// raises Lua errors.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <lua.hpp>
#include <string>
#include <string_view>

#include "core/config.h"
#include "core/maths.h"
#include "core/text.h"
#include "game/scenario/sandbox.h"

namespace thaum::game::inline scenario::arguments {

template <class... Parts>
[[noreturn]] void fault(const Parts&... parts) {
    throw ScriptFault{text(parts...)};
}

double number(lua_State* lua, int index, std::string_view name, Range range);
std::int64_t integer(lua_State* lua, int index, std::string_view name, Range range);
std::string string(lua_State* lua, int index, std::string_view name);
/// Reads a text of lower-case letters, digits and _, which is safe as a file name.
std::string plain_name(lua_State* lua, int index, std::string_view name);
/// Reads a player, 1 or 2, and returns the index.
std::uint32_t player(lua_State* lua, int index);
/// Reads {x, y, z} or {x = , y = , z = }. Each value must lie within +-most.
vec3 place(lua_State* lua, int index, std::string_view name, double most);

/// Sets a field of the table on top of the stack.
void set_number(lua_State* lua, const char* key, double value);
void set_text(lua_State* lua, const char* key, std::string_view value);
void set_flag(lua_State* lua, const char* key, bool value);
void set_place(lua_State* lua, const char* key, vec3 value);

void push_place(lua_State* lua, vec3 value);

/// The table of options at `index`. Each of its keys must be in `names`. `has` pushes fields onto the Lua
/// stack and leaves them there; the stack is cleared when the verb returns.
class Options {
public:
    Options(lua_State* lua, int index, std::string_view verb, std::initializer_list<std::string_view> names);
    /// Returns true if the option exists. Its value is then on top of the stack.
    bool has(const char* name) const;
    /// Like `has`, but a missing option is a fault.
    void need(const char* name) const;

private:
    lua_State* lua_;
    int index_;
};

}  // namespace thaum::game::inline scenario::arguments
