// game/scenario/detail/arguments.h: reads the arguments of verbs from Lua's stack. A wrong argument throws a
// ScriptFault that names it. No function here calls metamethods or raises Lua errors.
#pragma once
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <lua.hpp>
#include <string>
#include <vector>

#include "core/config.h"
#include "core/maths.h"
#include "core/text.h"
#include "game/scenario/sandbox.h"

namespace thaum::game::arguments {

template <class... Parts>
[[noreturn]] void fault(const Parts&... parts) {
    throw ScriptFault{text(parts...)};
}

inline double number(lua_State* lua, int index, std::string_view name, Range range) {
    if (lua_type(lua, index) != LUA_TNUMBER) {
        fault(name, " must be a number, not ", std::string_view(luaL_typename(lua, index)));
    }
    const double value = lua_tonumber(lua, index);
    if (!(value >= range.low && value <= range.high)) {
        fault(name, " = ", value, " must be in ", range.low, " .. ", range.high);
    }
    return value;
}

inline std::int64_t integer(lua_State* lua, int index, std::string_view name, Range range) {
    const double value = number(lua, index, name, range);
    if (std::floor(value) != value) fault(name, " = ", value, " must be a whole number");
    return static_cast<std::int64_t>(value);
}

inline std::string string(lua_State* lua, int index, std::string_view name) {
    if (lua_type(lua, index) != LUA_TSTRING) {
        fault(name, " must be text, not ", std::string_view(luaL_typename(lua, index)));
    }
    std::size_t size = 0;
    const char* const chars = lua_tolstring(lua, index, &size);
    return {chars, size};
}

/// Text of lower-case letters, digits and _, safe as a file name.
inline std::string plain_name(lua_State* lua, int index, std::string_view name) {
    auto value = string(lua, index, name);
    const bool plain =
        !value.empty() && value.size() <= 64 && std::all_of(value.begin(), value.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        });
    if (!plain) fault(name, " must be made of a-z, 0-9 and _");
    return value;
}

inline std::uint32_t player(lua_State* lua, int index) {
    return static_cast<std::uint32_t>(integer(lua, index, "a player", {1, 2}) - 1);
}

/// Reads {x, y, z} or {x = , y = , z = }. Each value must lie within +-most.
inline vec3 place(lua_State* lua, int index, std::string_view name, double most) {
    if (!lua_istable(lua, index))
        fault(name, " must be {x, y, z}, not ", std::string_view(luaL_typename(lua, index)));
    index = lua_absindex(lua, index);
    static constexpr const char* letters[] = {"x", "y", "z"};
    vec3 value;
    for (int i = 0; i < 3; ++i) {
        if (lua_rawgeti(lua, index, i + 1) == LUA_TNIL) {
            lua_pop(lua, 1);
            lua_pushstring(lua, letters[i]);
            lua_rawget(lua, index);
        }
        value[i] = number(lua, -1, text(name, ".", letters[i][0]), {-most, most});
        lua_pop(lua, 1);
    }
    return value;
}

/// Sets a field of the table on top of the stack.
inline void set_number(lua_State* lua, const char* key, double value) {
    lua_pushnumber(lua, value);
    lua_setfield(lua, -2, key);
}
inline void set_text(lua_State* lua, const char* key, std::string_view value) {
    lua_pushlstring(lua, value.data(), value.size());
    lua_setfield(lua, -2, key);
}

inline void push_place(lua_State* lua, vec3 value) {
    lua_createtable(lua, 0, 3);
    lua_pushnumber(lua, value.x);
    lua_setfield(lua, -2, "x");
    lua_pushnumber(lua, value.y);
    lua_setfield(lua, -2, "y");
    lua_pushnumber(lua, value.z);
    lua_setfield(lua, -2, "z");
}

/// The table of options at `index`. Each of its keys must be in `names`. `has` pushes fields and leaves them
/// on the stack, which is cleared when the verb returns.
class Options {
public:
    Options(lua_State* lua, int index, std::string_view verb, std::initializer_list<std::string_view> names)
        : lua_(lua), index_(index) {
        if (!lua_istable(lua, index)) fault(verb, " takes a table: ", verb, "{...}");
        for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
            const auto key =
                lua_type(lua, -2) == LUA_TSTRING ? string(lua, -2, "a key") : std::string("a list");
            if (std::find(names.begin(), names.end(), key) == names.end())
                fault(verb, " knows no '", key, "'");
        }
    }
    /// Returns true if the option exists. Its value is then on top of the stack.
    bool has(const char* name) const {
        lua_pushstring(lua_, name);
        return lua_rawget(lua_, index_) != LUA_TNIL;
    }
    void need(const char* name) const {
        if (!has(name)) fault("'", std::string_view(name), "' is missing");
    }

private:
    lua_State* lua_;
    int index_;
};

}  // namespace thaum::game::arguments
