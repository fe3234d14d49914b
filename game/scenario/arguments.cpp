#include "game/scenario/detail/arguments.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline scenario::arguments {

double number(lua_State* lua, int index, std::string_view name, Range range) {
    if (lua_type(lua, index) != LUA_TNUMBER) {
        fault(name, " must be a number, not ", std::string_view(luaL_typename(lua, index)));
    }
    const double value = lua_tonumber(lua, index);
    if (!(value >= range.low && value <= range.high)) {
        fault(name, " = ", value, " must be in ", range.low, " .. ", range.high);
    }
    return value;
}

std::int64_t integer(lua_State* lua, int index, std::string_view name, Range range) {
    const double value = number(lua, index, name, range);
    if (std::floor(value) != value) fault(name, " = ", value, " must be a whole number");
    return static_cast<std::int64_t>(value);
}

std::string string(lua_State* lua, int index, std::string_view name) {
    if (lua_type(lua, index) != LUA_TSTRING) {
        fault(name, " must be text, not ", std::string_view(luaL_typename(lua, index)));
    }
    std::size_t size = 0;
    const char* const chars = lua_tolstring(lua, index, &size);
    return {chars, size};
}

std::string plain_name(lua_State* lua, int index, std::string_view name) {
    auto value = string(lua, index, name);
    const bool plain =
        !value.empty() && value.size() <= 64 && std::all_of(value.begin(), value.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        });
    if (!plain) fault(name, " must be made of a-z, 0-9 and _");
    return value;
}

std::uint32_t player(lua_State* lua, int index) {
    return static_cast<std::uint32_t>(integer(lua, index, "a player", {1, 2}) - 1);
}

vec3 place(lua_State* lua, int index, std::string_view name, double most) {
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

void set_number(lua_State* lua, const char* key, double value) {
    lua_pushnumber(lua, value);
    lua_setfield(lua, -2, key);
}

void set_text(lua_State* lua, const char* key, std::string_view value) {
    lua_pushlstring(lua, value.data(), value.size());
    lua_setfield(lua, -2, key);
}

void set_flag(lua_State* lua, const char* key, bool value) {
    lua_pushboolean(lua, static_cast<int>(value));
    lua_setfield(lua, -2, key);
}

void set_place(lua_State* lua, const char* key, vec3 value) {
    push_place(lua, value);
    lua_setfield(lua, -2, key);
}

void push_place(lua_State* lua, vec3 value) {
    lua_createtable(lua, 0, 3);
    set_number(lua, "x", value.x);
    set_number(lua, "y", value.y);
    set_number(lua, "z", value.z);
}

Options::Options(lua_State* lua, int index, std::string_view verb,
                 std::initializer_list<std::string_view> names)
    : lua_(lua), index_(index) {
    if (!lua_istable(lua, index)) fault(verb, " takes a table: ", verb, "{...}");
    for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
        const auto key = lua_type(lua, -2) == LUA_TSTRING ? string(lua, -2, "a key") : std::string("a list");
        if (std::find(names.begin(), names.end(), key) == names.end()) fault(verb, " knows no '", key, "'");
    }
}

bool Options::has(const char* name) const {
    lua_pushstring(lua_, name);
    return lua_rawget(lua_, index_) != LUA_TNIL;
}

void Options::need(const char* name) const {
    if (!has(name)) fault("'", std::string_view(name), "' is missing");
}

}  // namespace thaum::game::inline scenario::arguments
