// find, match, gmatch and gsub for scripts, on the counted matcher of patterns.h. These are plain Lua C
// functions. An error jumps over their frames, so no object in them needs a destructor.
#include <algorithm>
#include <type_traits>

#include "game/scenario/detail/sandbox_state.h"
#include "game/scenario/patterns.h"

namespace thaum::game {
namespace {

static_assert(std::is_trivially_destructible_v<PatternMatch>);

bool spend(void* state, std::uint64_t steps) { return static_cast<Sandbox::State*>(state)->spend(steps); }

std::string_view text_argument(lua_State* lua, int index) {
    std::size_t size = 0;
    const char* const chars = luaL_checklstring(lua, index, &size);
    return {chars, size};
}

/// Converts an argument that counts from 1, or from the end if negative, to a position from 0.
std::size_t place_argument(lua_State* lua, int index, std::size_t size) {
    const auto place = luaL_optinteger(lua, index, 1);
    if (place > 0) return static_cast<std::size_t>(place) - 1;
    const auto from_end = static_cast<std::uint64_t>(0) - static_cast<std::uint64_t>(place);
    return place == 0 || from_end > size ? 0 : size - static_cast<std::size_t>(from_end);
}

/// Raises the fault of the pattern, or the error that no steps are left.
int raise(lua_State* lua, const char* fault) {
    state_of(lua).trusted = true;
    lua_pushstring(lua, fault);
    return raise_at_script(lua);
}

constexpr const char* no_steps_left =
    "the script has spent all its steps: this search in a text of that length takes too long";

void push_part(lua_State* lua, std::string_view part) { lua_pushlstring(lua, part.data(), part.size()); }

void push_capture(lua_State* lua, const PatternMatch& match, std::string_view subject, std::size_t i) {
    const auto& capture = match.capture(i);
    if (capture.kind == Capture::Kind::open) raise(lua, "unfinished capture");
    if (capture.kind == Capture::Kind::position)
        lua_pushinteger(lua, static_cast<lua_Integer>(capture.begin) + 1);
    else
        push_part(lua, subject.substr(capture.begin, capture.size));
}

/// Pushes all captures. If there are none and `whole` is set, pushes the whole match, which begins at
/// `begin`.
int push_captures(lua_State* lua, const PatternMatch& match, std::string_view subject, std::size_t begin,
                  bool whole) {
    luaL_checkstack(lua, static_cast<int>(most_captures), "too many captures");
    for (std::size_t i = 0; i < match.captures(); ++i) push_capture(lua, match, subject, i);
    if (match.captures() > 0 || !whole) return static_cast<int>(match.captures());
    push_part(lua, subject.substr(begin, match.end() - begin));
    return 1;
}

bool is_plain(std::string_view pattern) {
    return pattern.find_first_of("^$*+?.([%-") == std::string_view::npos;
}

int push_plain(lua_State* lua, std::string_view subject, std::string_view wanted, std::size_t from) {
    const auto found = find_plain(subject, wanted, from, spend, &state_of(lua));
    if (state_of(lua).exhausted) return raise(lua, no_steps_left);
    if (found == std::string_view::npos) {
        lua_pushnil(lua);
        return 1;
    }
    lua_pushinteger(lua, static_cast<lua_Integer>(found) + 1);
    lua_pushinteger(lua, static_cast<lua_Integer>(found) + static_cast<lua_Integer>(wanted.size()));
    return 2;
}

/// string.find and string.match.
template <bool find>
int first_match(lua_State* lua) {
    const auto subject = text_argument(lua, 1);
    auto pattern = text_argument(lua, 2);
    auto at = place_argument(lua, 3, subject.size());
    if (at > subject.size()) {
        lua_pushnil(lua);
        return 1;
    }
    if (find && (lua_toboolean(lua, 4) != 0 || is_plain(pattern)))
        return push_plain(lua, subject, pattern, at);
    const bool anchored = pattern.starts_with('^');
    if (anchored) pattern.remove_prefix(1);
    PatternMatch match(subject, pattern, spend, &state_of(lua));
    for (; at <= subject.size() && match.spend(1); ++at) {
        if (match.match_at(at)) {
            if (!find) return push_captures(lua, match, subject, at, true);
            lua_pushinteger(lua, static_cast<lua_Integer>(at) + 1);
            lua_pushinteger(lua, static_cast<lua_Integer>(match.end()));
            return 2 + push_captures(lua, match, subject, at, false);
        }
        if (anchored || match.fault() != nullptr) break;
    }
    if (match.fault() != nullptr) return raise(lua, match.fault());
    lua_pushnil(lua);
    return 1;
}

/// The iterator of gmatch. Upvalues: subject, pattern, next position, and end of the last match (from 0; -1:
/// none).
int next_match(lua_State* lua) {
    const auto subject = text_argument(lua, lua_upvalueindex(1));
    const auto pattern = text_argument(lua, lua_upvalueindex(2));
    const auto last = lua_tointeger(lua, lua_upvalueindex(4));
    PatternMatch match(subject, pattern, spend, &state_of(lua));
    for (auto at = static_cast<std::size_t>(lua_tointeger(lua, lua_upvalueindex(3)));
         at <= subject.size() && match.spend(1); ++at) {
        if (match.match_at(at) && static_cast<lua_Integer>(match.end()) != last) {
            for (const int upvalue : {3, 4}) {
                lua_pushinteger(lua, static_cast<lua_Integer>(match.end()));
                lua_replace(lua, lua_upvalueindex(upvalue));
            }
            return push_captures(lua, match, subject, at, true);
        }
        if (match.fault() != nullptr) break;
    }
    if (match.fault() != nullptr) return raise(lua, match.fault());
    return 0;
}

int all_matches(lua_State* lua) {
    const auto subject = text_argument(lua, 1);
    text_argument(lua, 2);
    const auto at = std::min(place_argument(lua, 3, subject.size()), subject.size() + 1);
    lua_settop(lua, 2);
    lua_pushinteger(lua, static_cast<lua_Integer>(at));
    lua_pushinteger(lua, -1);
    lua_pushcclosure(lua, next_match, 4);
    return 1;
}

/// A match that gsub replaces.
struct Replaced {
    PatternMatch& match;
    std::string_view subject;
    std::size_t begin;

    std::string_view whole() const { return subject.substr(begin, match.end() - begin); }
};

/// Adds the replacement text (argument 3) with its %0 to %9 filled in. Every byte is charged, since captures
/// can be empty.
void add_filled_in(lua_State* lua, luaL_Buffer& out, const Replaced& found) {
    const auto words = text_argument(lua, 3);
    if (!found.match.spend(words.size())) raise(lua, found.match.fault());
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] != '%') {
            luaL_addchar(&out, words[i]);
            continue;
        }
        const char name = ++i < words.size() ? words[i] : '\0';
        const auto number = static_cast<std::size_t>(name - '1');
        if (name == '%') {
            luaL_addchar(&out, '%');
        } else if (name == '0' || (name == '1' && found.match.captures() == 0)) {
            luaL_addlstring(&out, found.whole().data(), found.whole().size());
        } else if (name < '0' || name > '9') {
            raise(lua, "invalid use of '%' in replacement string");
        } else if (number >= found.match.captures()) {
            raise(lua, "invalid capture index in replacement string");
        } else {
            push_capture(lua, found.match, found.subject, number);
            luaL_tolstring(lua, -1, nullptr);
            lua_remove(lua, -2);
            luaL_addvalue(&out);
        }
    }
}

/// Adds the result of a table or function (argument 3) for the match. Adds the match itself if the result is
/// nil or false.
void add_looked_up(lua_State* lua, luaL_Buffer& out, const Replaced& found) {
    if (lua_type(lua, 3) == LUA_TTABLE) {
        if (found.match.captures() > 0)
            push_capture(lua, found.match, found.subject, 0);
        else
            push_part(lua, found.whole());
        lua_gettable(lua, 3);
    } else {
        lua_pushvalue(lua, 3);
        lua_call(lua, push_captures(lua, found.match, found.subject, found.begin, true), 1);
    }
    if (lua_toboolean(lua, -1) == 0) {
        lua_pop(lua, 1);
        luaL_addlstring(&out, found.whole().data(), found.whole().size());
    } else if (lua_isstring(lua, -1) != 0) {
        luaL_addvalue(&out);
    } else {
        luaL_error(lua, "invalid replacement value (a %s)", luaL_typename(lua, -1));
    }
}

/// Adds the subject with at most `most` matches replaced. Returns the number of replacements.
lua_Integer add_replaced(lua_State* lua, luaL_Buffer& out, PatternMatch& match, std::string_view subject,
                         bool once, lua_Integer most) {
    lua_Integer count = 0;
    std::size_t at = 0, last = std::string_view::npos;
    const bool words = lua_isstring(lua, 3) != 0;
    while (count < most && match.spend(1)) {
        if (match.match_at(at) && match.end() != last) {
            ++count;
            const Replaced found{match, subject, at};
            words ? add_filled_in(lua, out, found) : add_looked_up(lua, out, found);
            at = last = match.end();
        } else if (at < subject.size() && match.fault() == nullptr) {
            luaL_addchar(&out, subject[at++]);
        } else {
            break;
        }
        if (once) break;
    }
    if (match.fault() != nullptr) raise(lua, match.fault());
    luaL_addlstring(&out, subject.data() + at, subject.size() - at);
    return count;
}

int replace_matches(lua_State* lua) {
    const auto subject = text_argument(lua, 1);
    auto pattern = text_argument(lua, 2);
    const int type = lua_type(lua, 3);
    luaL_argexpected(
        lua, type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TFUNCTION || type == LUA_TTABLE, 3,
        "string/function/table");
    const auto most = luaL_optinteger(lua, 4, static_cast<lua_Integer>(subject.size()) + 1);
    const bool anchored = pattern.starts_with('^');
    if (anchored) pattern.remove_prefix(1);
    PatternMatch match(subject, pattern, spend, &state_of(lua));
    luaL_Buffer out;
    luaL_buffinit(lua, &out);
    const auto count = add_replaced(lua, out, match, subject, anchored, most);
    luaL_pushresult(&out);
    lua_pushinteger(lua, count);
    return 2;
}

constexpr luaL_Reg counted_matching[] = {{"find", first_match<true>},
                                         {"match", first_match<false>},
                                         {"gmatch", all_matches},
                                         {"gsub", replace_matches},
                                         {nullptr, nullptr}};

}  // namespace

void set_matching(lua_State* lua) { luaL_setfuncs(lua, counted_matching, 0); }

}  // namespace thaum::game
