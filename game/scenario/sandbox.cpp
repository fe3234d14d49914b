#include "game/scenario/sandbox.h"

#include <cstdlib>
#include <system_error>

#include "core/assert.h"
#include "core/clock.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/scenario/detail/sandbox_state.h"

namespace thaum::game::inline scenario {
namespace {

constexpr int resume_steps = 100;
constexpr std::size_t memory_per_step = 64;  ///< requested memory that costs one step (bytes)
/// Memory that trusted code may use beyond the limit between two checks (bytes).
constexpr std::size_t reserve = 8U << 20U;

using State = Sandbox::State;

bool allowed(const State& state, std::size_t old_size, std::size_t new_size) {
    const auto after = state.memory - old_size + new_size;
    if (state.trusted) return after <= state.limits.memory + reserve;
    return !state.exhausted && new_size <= state.limits.block && after <= state.limits.memory;
}

/// Lua's only allocator. Shrinking a block must never fail.
void* allocate(void* context, void* block, std::size_t old_size, std::size_t new_size) {
    auto& state = *static_cast<State*>(context);
    // For a new block, Lua passes the kind of object here instead of a size.
    if (block == nullptr) old_size = 0;
    if (new_size == 0) {
        std::free(block);
        state.memory -= old_size;
        return nullptr;
    }
    if (new_size > old_size) {
        state.spend((new_size - old_size) / memory_per_step);
        if (!allowed(state, old_size, new_size)) return nullptr;
    }
    void* const moved = std::realloc(block, new_size);
    if (moved != nullptr) state.memory = state.memory - old_size + new_size;
    return moved;
}

constexpr const char* endless = "the script has spent all its steps: an endless loop?";
constexpr const char* out_of_time =
    "the script has used all its processor time, and was stopped: use shorter texts and lists";

bool is_on_time(const State& state) {
    return !state.late && thread_cpu_ns() < state.deadline_ns &&
           static_cast<double>(state.verbs_ns) < state.limits.verbs_s * 1e9;
}

void count_steps(lua_State* lua, lua_Debug*) { charge(lua, hook_steps); }

struct VerbEntry {
    Sandbox::Verb verb;
    void* context;
};

constexpr int failed = -2;

/// Catches every C++ exception before it reaches Lua's frames.
int guarded_call(lua_State* lua, const VerbEntry& entry, State& state) noexcept {
    int results = failed;
    const auto began_ns = thread_cpu_ns();
    state.trusted = true;
    try {
        lua_checkstack(lua, 40);
        results = entry.verb(lua, entry.context);
    } catch (ScriptFault& fault) {
        state.fault = std::move(fault.message);
    } catch (const std::system_error&) {
        state.fault = "the system allows no further thread";
    } catch (...) {
        state.fault = "out of memory";
    }
    state.trusted = false;
    const auto took_ns = thread_cpu_ns() - began_ns;
    state.deadline_ns += took_ns;
    state.verbs_ns += took_ns;
    return results;
}

/// Calls a verb (a function of the program) for a script. The last lines may raise a Lua error, whose longjmp
/// skips this frame, so the function holds no object with a destructor.
int call_verb(lua_State* lua) {
    auto& state = state_of(lua);
    const auto& entry = *static_cast<const VerbEntry*>(lua_touserdata(lua, lua_upvalueindex(1)));
    const int results = guarded_call(lua, entry, state);
    if (results == failed) {
        state.trusted = true;
        lua_pushlstring(lua, state.fault.data(), state.fault.size());
        return raise_at_script(lua);
    }
    charge(lua, 0);
    // A verb (a function of the program) may exceed the memory limit temporarily, but afterwards the script
    // must be within it.
    if (state.memory > state.limits.memory) lua_gc(lua, LUA_GCCOLLECT);
    if (state.memory > state.limits.memory) return luaL_error(lua, "not enough memory");
    if (results != Sandbox::wait) return results;
    if (lua != state.script) {
        lua_pushliteral(lua, "a verb that takes time stands in a coroutine of the script's own");
        return raise_at_script(lua);
    }
    return lua_yield(lua, 0);
}

/// Message of the error on the stack, as one line.
std::string message_of(lua_State* lua) {
    std::size_t size = 0;
    const char* const message = lua_type(lua, -1) == LUA_TSTRING ? lua_tolstring(lua, -1, &size) : nullptr;
    if (message == nullptr) return text("an error that is no text but a ", luaL_typename(lua, -1));
    return in_one_line({message, size});
}

/// Loads source text (compiled code is refused) as a function on top of the stack.
Expected<void> load(lua_State* lua, std::string_view source, const std::string& chunk) {
    const int status = luaL_loadbufferx(lua, source.data(), source.size(), chunk.c_str(), "t");
    if (status == LUA_OK) return {};
    auto message = message_of(lua);
    lua_pop(lua, 1);
    return fail(std::move(message));
}

int open_all(lua_State* lua) {
    open_library(lua);
    return 0;
}

}  // namespace

void charge(lua_State* lua, std::uint64_t steps) {
    auto& state = state_of(lua);
    const bool on_time = is_on_time(state);
    if (state.spend(steps) && on_time) return;
    state.late = state.late || !on_time;
    state.exhausted = true;
    state.trusted = true;
    lua_pushstring(lua, state.late ? out_of_time : endless);
    raise_at_script(lua);
}

int raise_at_script(lua_State* lua) {
    auto& state = state_of(lua);
    state.trusted = true;  // trusted, because building the message must not fail
    lua_Debug frame;
    for (int level = 0; lua_getstack(lua, level, &frame) != 0; ++level) {
        lua_getinfo(lua, "Sl", &frame);
        if (frame.currentline <= 0 || std::string_view(frame.source) == prelude_name) continue;
        lua_pushfstring(lua, "%s:%d: ", frame.short_src, frame.currentline);
        lua_insert(lua, -2);
        lua_concat(lua, 2);
        break;
    }
    state.trusted = false;
    return lua_error(lua);
}

Sandbox::Sandbox(const SandboxLimits& limits) : state_(std::make_unique<State>()) {
    state_->limits = limits;
    state_->lua = lua_newstate(allocate, state_.get());
    THAUM_ASSERT(state_->lua != nullptr, "no memory for a Lua state");
    auto* const lua = state_->lua;
    *static_cast<State**>(lua_getextraspace(lua)) = state_.get();
    state_->trusted = true;
    lua_pushcfunction(lua, open_all);
    const int status = lua_pcall(lua, 0, 0, 0);
    state_->trusted = false;
    THAUM_ASSERT(status == LUA_OK, message_of(lua));
    state_->steps = 0;
    lua_sethook(lua, count_steps, LUA_MASKCOUNT, hook_steps);
}

Sandbox::~Sandbox() { lua_close(state_->lua); }

void Sandbox::add(const char* name, Verb verb, void* context) {
    auto* const lua = state_->lua;
    state_->trusted = true;
    auto* const entry = static_cast<VerbEntry*>(lua_newuserdatauv(lua, sizeof(VerbEntry), 0));
    *entry = {verb, context};
    lua_pushcclosure(lua, call_verb, 1);
    lua_setglobal(lua, name);
    state_->trusted = false;
}

Expected<void> Sandbox::run_prelude(std::string_view source) {
    auto* const lua = state_->lua;
    if (auto loaded = load(lua, source, prelude_name); !loaded) return loaded;
    if (lua_pcall(lua, 0, 0, 0) == LUA_OK) return {};
    auto message = message_of(lua);
    lua_pop(lua, 1);
    return fail(std::move(message));
}

Expected<void> Sandbox::start(std::string_view source, std::string_view name) {
    auto* const lua = state_->lua;
    if (const auto line = line_of_power(source)) {
        return fail(
            text(name, ":", *line, ": the operator ^ is not the same on every machine: math.pow(x, y)"));
    }
    state_->trusted = true;
    lua_settop(lua, 0);
    state_->script = lua_newthread(lua);
    state_->trusted = false;
    state_->name = name;
    return load(state_->script, source, text("@", name));
}

Expected<Sandbox::Progress> Sandbox::resume() {
    state_->spend(resume_steps);
    int results = 0;
    const auto left_ns = static_cast<std::int64_t>(state_->limits.compute_s * 1e9) - state_->computed_ns;
    state_->deadline_ns = thread_cpu_ns() + left_ns;
    const int status = lua_resume(state_->script, state_->lua, 0, &results);
    state_->computed_ns += left_ns - (state_->deadline_ns - thread_cpu_ns());
    if (status == LUA_OK) return Progress::done;
    if (status == LUA_YIELD) {
        lua_pop(state_->script, results);
        return Progress::waits;
    }
    auto message = message_of(state_->script);
    // If the steps ran out during an allocation, Lua's message says only that memory is short, so it is
    // replaced.
    const std::string why = state_->late ? out_of_time : endless;
    if (state_->exhausted && message.find("steps") == std::string::npos &&
        message.find("processor time") == std::string::npos)
        message = text(state_->name, ": ", why);
    return fail(std::move(message));
}

const std::string& Sandbox::output() const { return state_->output; }
std::uint64_t Sandbox::steps() const { return state_->steps; }
std::size_t Sandbox::memory() const { return state_->memory; }
bool Sandbox::exhausted() const { return state_->exhausted; }

}  // namespace thaum::game::inline scenario
