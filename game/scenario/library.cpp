// The sandbox's library: Lua's own functions where they are safe, replacements where they are not. These are
// plain Lua C functions. They may raise errors, so no object in them needs a destructor
// (detail/sandbox_state.h).
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/maths.h"
#include "core/text.h"
#include "game/scenario/detail/sandbox_state.h"

namespace thaum::game::inline scenario {
namespace {

// ---- errors that no pcall may keep ------------------------------------------------------------------------

int end_of_pcall(lua_State* lua, int status, lua_KContext) {
    if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(lua);
    state_of(lua).trusted = false;
    if (state_of(lua).exhausted) return lua_error(lua);
    lua_pushboolean(lua, 0);
    lua_insert(lua, -2);
    return 2;
}

int safe_pcall(lua_State* lua) {
    luaL_checkany(lua, 1);
    lua_pushboolean(lua, 1);
    lua_insert(lua, 1);
    return end_of_pcall(lua, lua_pcallk(lua, lua_gettop(lua) - 2, LUA_MULTRET, 0, 0, end_of_pcall), 0);
}

/// Calls Lua's original function (upvalue 1) with the given arguments and returns all its results.
int call_wrapped(lua_State* lua) {
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, LUA_MULTRET);
    return lua_gettop(lua);
}

/// Lua's own coroutine.create or coroutine.wrap (upvalue 1). Each coroutine counts its instructions anew, so
/// creating one costs as many steps as its count can miss.
int make_coroutine(lua_State* lua) {
    charge(lua, hook_steps);
    return call_wrapped(lua);
}

/// Wraps Lua's own coroutine.resume or coroutine.close (upvalue 1). Both catch errors themselves, so the
/// error of used-up steps is raised again.
int call_catcher(lua_State* lua) {
    call_wrapped(lua);
    const bool caught = lua_gettop(lua) >= 2 && lua_isboolean(lua, 1) && lua_toboolean(lua, 1) == 0;
    if (caught && state_of(lua).exhausted) {
        lua_settop(lua, 2);
        return lua_error(lua);
    }
    return lua_gettop(lua);
}

// ---- text without addresses -------------------------------------------------------------------------------

/// Works like luaL_tolstring, but a value without text becomes the name of its type.
void push_text(lua_State* lua, int index) {
    index = lua_absindex(lua, index);
    if (luaL_callmeta(lua, index, "__tostring") != 0) {
        if (lua_type(lua, -1) != LUA_TSTRING) luaL_error(lua, "'__tostring' must return a string");
        return;
    }
    switch (lua_type(lua, index)) {
        case LUA_TNIL:
        case LUA_TBOOLEAN:
        case LUA_TNUMBER:
        case LUA_TSTRING: luaL_tolstring(lua, index, nullptr); break;
        default: lua_pushstring(lua, luaL_typename(lua, index)); break;
    }
}

int safe_tostring(lua_State* lua) {
    luaL_checkany(lua, 1);
    push_text(lua, 1);
    return 1;
}

/// Replaces each argument that has no text form by the name of its type, so that no memory address is shown.
void hide_addresses(lua_State* lua) {
    for (int i = 2; i <= lua_gettop(lua); ++i) {
        const int type = lua_type(lua, i);
        if (type == LUA_TNIL || type == LUA_TBOOLEAN || type == LUA_TNUMBER || type == LUA_TSTRING) continue;
        push_text(lua, i);
        lua_replace(lua, i);
    }
}

bool has_pointer_format(const char* format) {
    for (const char* at = std::strchr(format, '%'); at != nullptr; at = std::strchr(at, '%')) {
        ++at;
        if (*at == '%') {
            ++at;
            continue;
        }
        at += std::strspn(at, "-+ #0123456789.");
        if (*at == 'p') return true;
    }
    return false;
}

/// Wraps string.format (upvalue 1: Lua's original), so that it shows no addresses.
int safe_format(lua_State* lua) {
    if (has_pointer_format(luaL_checkstring(lua, 1)))
        return luaL_error(lua, "%%p: addresses are not for scripts");
    hide_addresses(lua);
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, 1);
    return 1;
}

void append_output(Sandbox::State& state, const char* chars, std::size_t size) noexcept {
    if (state.output.size() >= state.limits.output) return;
    state.output.append(chars, std::min(size, state.limits.output - state.output.size()));
}

int safe_print(lua_State* lua) {
    auto& state = state_of(lua);
    const int count = lua_gettop(lua);
    for (int i = 1; i <= count; ++i) {
        push_text(lua, i);
        std::size_t size = 0;
        const char* const chars = lua_tolstring(lua, -1, &size);
        if (i > 1) append_output(state, "\t", 1);
        append_output(state, chars, size);
        lua_pop(lua, 1);
    }
    append_output(state, "\n", 1);
    return 0;
}

// ---- pairs in sorted order --------------------------------------------------------------------------------

/// A key of a table, of a type that can be sorted.
struct SortKey {
    int type;
    bool whole;  ///< true for an integer key, false for a float key
    lua_Integer integer;
    lua_Number number;
    const char* chars;  ///< points into a string that is alive as long as the table
    std::size_t size;
};

/// Compares an integer key with a float key. A float key has a fraction or is beyond all integers, because
/// Lua converts other floats to integers.
bool integer_before(lua_Integer i, lua_Number f) {
    if (f >= 0x1p63) return true;
    if (f < -0x1p63) return false;
    return i <= static_cast<lua_Integer>(std::floor(f));
}

bool number_before(const SortKey& a, const SortKey& b) {
    if (a.whole && b.whole) return a.integer < b.integer;
    if (a.whole) return integer_before(a.integer, b.number);
    if (b.whole) return !integer_before(b.integer, a.number);
    return a.number < b.number;
}

bool string_before(const SortKey& a, const SortKey& b) {
    return std::string_view(a.chars, a.size) < std::string_view(b.chars, b.size);
}

int rank(int type) { return type == LUA_TNUMBER ? 0 : type == LUA_TSTRING ? 1 : 2; }

bool before(const SortKey& a, const SortKey& b) {
    if (rank(a.type) != rank(b.type)) return rank(a.type) < rank(b.type);
    if (a.type == LUA_TNUMBER) return number_before(a, b);
    if (a.type == LUA_TSTRING) return string_before(a, b);
    return a.integer < b.integer;
}

SortKey sort_key(lua_State* lua, int index) {
    SortKey key{lua_type(lua, index), lua_isinteger(lua, index) != 0, 0, 0, nullptr, 0};
    switch (key.type) {
        case LUA_TNUMBER:
            key.integer = key.whole ? lua_tointeger(lua, index) : 0;
            key.number = lua_tonumber(lua, index);
            break;
        case LUA_TSTRING: key.chars = lua_tolstring(lua, index, &key.size); break;
        case LUA_TBOOLEAN: key.integer = lua_toboolean(lua, index); break;
        default: luaL_error(lua, "pairs: a key that is a %s has no order", lua_typename(lua, key.type));
    }
    return key;
}

void push_key(lua_State* lua, const SortKey& key) {
    if (key.type == LUA_TSTRING) {
        lua_pushlstring(lua, key.chars, key.size);
    } else if (key.type == LUA_TBOOLEAN) {
        lua_pushboolean(lua, key.integer != 0);
    } else if (key.whole) {
        lua_pushinteger(lua, key.integer);
    } else {
        lua_pushnumber(lua, key.number);
    }
}

std::size_t count_keys(lua_State* lua, int table) {
    std::size_t count = 0;
    for (lua_pushnil(lua); lua_next(lua, table) != 0; lua_pop(lua, 1)) ++count;
    return count;
}

/// Returns the next key and value whose value still exists. Upvalues: the table, its sorted keys, their
/// number, and the current position.
int next_sorted(lua_State* lua) {
    const auto count = lua_tointeger(lua, lua_upvalueindex(3));
    for (auto at = lua_tointeger(lua, lua_upvalueindex(4)) + 1; at <= count; ++at) {
        lua_settop(lua, 0);
        lua_rawgeti(lua, lua_upvalueindex(2), at);
        lua_pushvalue(lua, 1);
        lua_rawget(lua, lua_upvalueindex(1));
        if (lua_isnil(lua, 2)) continue;
        lua_pushinteger(lua, at);
        lua_replace(lua, lua_upvalueindex(4));
        return 2;
    }
    lua_pushnil(lua);
    return 1;
}

int sorted_pairs(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    lua_settop(lua, 1);
    const auto count = count_keys(lua, 1);
    auto* const keys = static_cast<SortKey*>(lua_newuserdatauv(lua, (count + 1) * sizeof(SortKey), 0));
    std::size_t filled = 0;
    for (lua_pushnil(lua); lua_next(lua, 1) != 0; lua_pop(lua, 1)) keys[filled++] = sort_key(lua, -2);
    std::sort(keys, keys + count, before);
    state_of(lua).spend(count);
    lua_pushvalue(lua, 1);
    lua_createtable(lua, static_cast<int>(std::min<std::size_t>(count, 1U << 16U)), 0);
    for (std::size_t i = 0; i < count; ++i) {
        push_key(lua, keys[i]);
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i) + 1);
    }
    lua_pushinteger(lua, static_cast<lua_Integer>(count));
    lua_pushinteger(lua, 0);
    lua_pushcclosure(lua, next_sorted, 4);
    return 1;
}

// ---- C loops that the instruction count does not see ------------------------------------------------------

constexpr lua_Integer max_moved = 1 << 16;

constexpr std::size_t bytes_per_step = 8;

/// Wraps utf8.len and utf8.offset, which may read the whole text (argument 1), so that a call costs the
/// text's length.
int counted_by_length(lua_State* lua) {
    std::size_t size = 0;
    luaL_checklstring(lua, 1, &size);
    state_of(lua).spend(size / bytes_per_step);
    return call_wrapped(lua);
}

/// Wraps string.byte and utf8.codepoint, so that a call costs the length of the text that it reads. They read
/// from argument 2 to argument 3, by default one character.
int counted_by_range(lua_State* lua) {
    std::size_t size = 0;
    luaL_checklstring(lua, 1, &size);
    const auto length = static_cast<lua_Integer>(size);
    const auto from_begin = [length](lua_Integer place) { return place < 0 ? place + length + 1 : place; };
    const auto first = from_begin(luaL_optinteger(lua, 2, 1));
    const auto last = from_begin(luaL_optinteger(lua, 3, first));
    const auto read = std::min(last, length) - std::max<lua_Integer>(first, 1);
    state_of(lua).spend(read > 0 ? static_cast<std::uint64_t>(read) / bytes_per_step : 0);
    return call_wrapped(lua);
}

int safe_rep(lua_State* lua) {
    std::size_t size = 0;
    std::size_t separator = 0;
    luaL_checklstring(lua, 1, &size);
    const auto count = luaL_checkinteger(lua, 2);
    luaL_optlstring(lua, 3, "", &separator);
    const auto limit = static_cast<double>(state_of(lua).limits.block);
    if (static_cast<double>(size + separator + 1) * static_cast<double>(count) > limit) {
        return luaL_error(lua, "string.rep: the result is too long");
    }
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, 1);
    return 1;
}

/// Wraps table.concat, table.move and table.unpack, and limits their range, which the arguments `at` and
/// `at + 1` give.
template <int at>
int safe_range(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    const auto first = luaL_optinteger(lua, at, 1);
    const auto last = lua_isnoneornil(lua, at + 1) ? luaL_len(lua, 1) : luaL_checkinteger(lua, at + 1);
    if (last >= first && static_cast<double>(last) - static_cast<double>(first) > max_moved) {
        return luaL_error(lua, "a range of more than %d", static_cast<int>(max_moved));
    }
    if (last >= first) state_of(lua).spend(static_cast<std::uint64_t>(last - first) / 4);
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, LUA_MULTRET);
    return lua_gettop(lua);
}

/// Total bytes of all texts in the list (argument 1), which sorting compares.
std::uint64_t bytes_in_list(lua_State* lua, lua_Integer count) {
    std::uint64_t bytes = 0;
    for (lua_Integer i = 1; i <= count; ++i) {
        if (lua_rawgeti(lua, 1, i) == LUA_TSTRING) bytes += lua_rawlen(lua, -1);
        lua_pop(lua, 1);
    }
    return bytes;
}

/// Wraps table.sort, so that a call costs its work: it compares each element about log2(count) times, and
/// texts byte by byte.
int counted_sort(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    const auto count = luaL_len(lua, 1);
    if (count > max_moved) return luaL_error(lua, "a list of more than %d", static_cast<int>(max_moved));
    const auto elements = static_cast<std::uint64_t>(std::max<lua_Integer>(0, count));
    const auto halvings = static_cast<std::uint64_t>(std::bit_width(elements));
    charge(lua, elements / 8 + halvings * bytes_in_list(lua, count) / bytes_per_step);
    return call_wrapped(lua);
}

/// Wraps table.insert and table.remove, so that a call costs the list's length, which a metatable may define.
int safe_length(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    if (luaL_len(lua, 1) > max_moved)
        return luaL_error(lua, "a list of more than %d", static_cast<int>(max_moved));
    state_of(lua).spend(static_cast<std::uint64_t>(std::max<lua_Integer>(0, luaL_len(lua, 1))) / 8);
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, LUA_MULTRET);
    return lua_gettop(lua);
}

// ---- the rest ---------------------------------------------------------------------------------------------

/// Rejects __gc and __mode, since scripts must not observe when memory is freed.
int safe_setmetatable(lua_State* lua) {
    if (lua_istable(lua, 2)) {
        for (const char* key : {"__gc", "__mode"}) {
            lua_pushstring(lua, key);
            if (lua_rawget(lua, 2) != LUA_TNIL) return luaL_error(lua, "%s is not for scripts", key);
            lua_pop(lua, 1);
        }
    }
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, 1);
    return 1;
}

template <double (*function)(double)>
int maths(lua_State* lua) {
    lua_pushnumber(lua, function(luaL_checknumber(lua, 1)));
    return 1;
}

int maths_atan(lua_State* lua) {
    lua_pushnumber(lua, det::atan2(luaL_checknumber(lua, 1), luaL_optnumber(lua, 2, 1)));
    return 1;
}

int maths_log(lua_State* lua) {
    const double x = det::log(luaL_checknumber(lua, 1));
    lua_pushnumber(lua, lua_isnoneornil(lua, 2) ? x : x / det::log(luaL_checknumber(lua, 2)));
    return 1;
}

int maths_pow(lua_State* lua) {
    lua_pushnumber(lua, det::pow(luaL_checknumber(lua, 1), luaL_checknumber(lua, 2)));
    return 1;
}

constexpr luaL_Reg our_maths[] = {{"sin", maths<det::sin>},   {"cos", maths<det::cos>},
                                  {"tan", maths<det::tan>},   {"asin", maths<det::asin>},
                                  {"acos", maths<det::acos>}, {"exp", maths<det::exp>},
                                  {"atan", maths_atan},       {"log", maths_log},
                                  {"pow", maths_pow},         {nullptr, nullptr}};

void remove_fields(lua_State* lua, int table, std::initializer_list<const char*> names) {
    table = lua_absindex(lua, table);
    for (const char* name : names) {
        lua_pushnil(lua);
        lua_setfield(lua, table, name);
    }
}

/// Replaces Lua's function of this name by our own, with the original as upvalue 1.
void wrap(lua_State* lua, int table, const char* name, lua_CFunction ours) {
    table = lua_absindex(lua, table);
    lua_getfield(lua, table, name);
    lua_pushcclosure(lua, ours, 1);
    lua_setfield(lua, table, name);
}

void set(lua_State* lua, int table, const char* name, lua_CFunction ours) {
    table = lua_absindex(lua, table);
    lua_pushcfunction(lua, ours);
    lua_setfield(lua, table, name);
}

/// Replaces string.find, match, gmatch and gsub (name: upvalue 1) by an error. Lua's own matcher counts no
/// steps, so one call with a few repetitions could take longer than a whole match.
int no_patterns(lua_State* lua) {
    lua_pushfstring(lua,
                    "string.%s: patterns are not available in scenarios: compare whole texts, take one apart "
                    "with string.sub, or use the lists in events and reports",
                    lua_tostring(lua, lua_upvalueindex(1)));
    return raise_at_script(lua);
}

void refuse_patterns(lua_State* lua, int table, const char* name) {
    table = lua_absindex(lua, table);
    lua_pushstring(lua, name);
    lua_pushcclosure(lua, no_patterns, 1);
    lua_setfield(lua, table, name);
}

void open_base(lua_State* lua) {
    luaL_requiref(lua, LUA_GNAME, luaopen_base, 1);
    remove_fields(lua, -1, {"load", "loadfile", "dofile", "collectgarbage", "warn", "next", "xpcall"});
    set(lua, -1, "pcall", safe_pcall);
    set(lua, -1, "tostring", safe_tostring);
    set(lua, -1, "print", safe_print);
    set(lua, -1, "pairs", sorted_pairs);
    wrap(lua, -1, "setmetatable", safe_setmetatable);
}

void open_string(lua_State* lua) {
    luaL_requiref(lua, LUA_STRLIBNAME, luaopen_string, 1);
    remove_fields(lua, -1, {"dump", "pack", "unpack", "packsize"});
    wrap(lua, -1, "format", safe_format);
    wrap(lua, -1, "rep", safe_rep);
    wrap(lua, -1, "byte", counted_by_range);
    for (const char* name : {"find", "match", "gmatch", "gsub"}) refuse_patterns(lua, -1, name);
    // Removes the operator ^ for texts, which would call the machine's own pow, as ^ does for numbers.
    lua_pushliteral(lua, "");
    lua_getmetatable(lua, -1);
    remove_fields(lua, -1, {"__pow"});
    lua_pop(lua, 2);
}

void open_table(lua_State* lua) {
    luaL_requiref(lua, LUA_TABLIBNAME, luaopen_table, 1);
    wrap(lua, -1, "unpack", safe_range<2>);
    wrap(lua, -1, "move", safe_range<2>);
    wrap(lua, -1, "concat", safe_range<3>);
    for (const char* name : {"insert", "remove"}) wrap(lua, -1, name, safe_length);
    wrap(lua, -1, "sort", counted_sort);
}

void open_maths(lua_State* lua) {
    luaL_requiref(lua, LUA_MATHLIBNAME, luaopen_math, 1);
    remove_fields(lua, -1, {"random", "randomseed"});
    luaL_setfuncs(lua, our_maths, 0);
}

void open_coroutine(lua_State* lua) {
    luaL_requiref(lua, LUA_COLIBNAME, luaopen_coroutine, 1);
    wrap(lua, -1, "resume", call_catcher);
    for (const char* name : {"create", "wrap"}) wrap(lua, -1, name, make_coroutine);
    wrap(lua, -1, "close", call_catcher);
}

/// Level (number of '=') of the long bracket that may begin with the '[' at `at`; -1 if there is none.
int long_level(std::string_view source, std::size_t at) {
    std::size_t end = at + 1;
    while (end < source.size() && source[end] == '=') ++end;
    return end < source.size() && source[end] == '[' ? static_cast<int>(end - at - 1) : -1;
}

/// Position after the end of the long text or comment that begins at `at` with a bracket of this level.
std::size_t skip_long(std::string_view source, std::size_t at, int level) {
    const auto close = text("]", std::string(static_cast<std::size_t>(level), '='), "]");
    const auto end = source.find(close, at);
    return end == std::string_view::npos ? source.size() : end + close.size();
}

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// Position after an escape sequence of a quoted text, as far as the sequence can hide the text's end. \z
/// skips all white space, line ends included. A line end of two characters counts as one.
std::size_t skip_escape(std::string_view source, std::size_t at) {
    const auto next = at + 1;
    if (next >= source.size()) return next;
    if (source[next] == 'z')
        return std::min(source.find_first_not_of(" \t\n\v\f\r", next + 1), source.size());
    const bool pair = is_line_end(source[next]) && next + 1 < source.size() &&
                      is_line_end(source[next + 1]) && source[next + 1] != source[next];
    return next + (pair ? 2 : 1);
}

std::size_t skip_quoted(std::string_view source, std::size_t at) {
    const char quote = source[at++];
    while (at < source.size() && source[at] != quote && !is_line_end(source[at]))
        at = source[at] == '\\' ? skip_escape(source, at) : at + 1;
    return at + 1;
}

std::size_t skip_remark(std::string_view source, std::size_t at) {
    if (at + 2 < source.size() && source[at + 2] == '[') {
        if (const int level = long_level(source, at + 2); level >= 0) return skip_long(source, at + 2, level);
    }
    return std::min(source.find_first_of("\n\r", at), source.size());
}

}  // namespace

void open_library(lua_State* lua) {
    open_base(lua);
    open_string(lua);
    open_table(lua);
    open_maths(lua);
    luaL_requiref(lua, LUA_UTF8LIBNAME, luaopen_utf8, 1);
    for (const char* name : {"len", "offset"}) wrap(lua, -1, name, counted_by_length);
    wrap(lua, -1, "codepoint", counted_by_range);
    open_coroutine(lua);
    lua_settop(lua, 0);
    // removes the table that `require` would search
    lua_pushnil(lua);
    lua_setfield(lua, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
}

std::optional<int> line_of_power(std::string_view source) {
    for (std::size_t at = 0; at < source.size();) {
        const char c = source[at];
        if (c == '^') {
            const auto begin = source.begin();
            return 1 + static_cast<int>(std::count(begin, begin + static_cast<std::ptrdiff_t>(at), '\n'));
        }
        const int level = c == '[' ? long_level(source, at) : -1;
        if (c == '"' || c == '\'') {
            at = skip_quoted(source, at);
        } else if (c == '-' && source.substr(at).starts_with("--")) {
            at = skip_remark(source, at);
        } else if (level >= 0) {
            at = skip_long(source, at, level);
        } else {
            ++at;
        }
    }
    return std::nullopt;
}

}  // namespace thaum::game::inline scenario
