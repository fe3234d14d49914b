// game/scenario/detail/verb.h: declarations shared by all files of verbs (the functions that scenario scripts
// call), and the lists of their verbs.
#pragma once
#include <span>

#include "game/data/event_kinds.h"
#include "game/scenario/detail/arguments.h"
#include "game/scenario/play.h"
#include "game/scenario/sandbox.h"

namespace thaum::game::inline scenario {

/// A verb and its name. Names that begin with raw_ are only for the prelude, the program's own Lua code,
/// which wraps these verbs and removes the names.
struct VerbName {
    const char* name;
    Sandbox::Verb verb;
};

std::span<const VerbName> thing_verbs();
std::span<const VerbName> report_verbs();
std::span<const VerbName> brew_verbs();
std::span<const VerbName> casting_verbs();
std::span<const VerbName> crystal_verbs();
std::span<const VerbName> orb_verbs();
std::span<const VerbName> sense_verbs();

// Limits that keep a script's values in the range of the physics.
inline constexpr double farthest = 500;  ///< greatest distance from the origin (m)
inline constexpr double fastest = 200;   ///< greatest speed that a script may set (m/s)

/// Returns the Play (one run of a scenario) that `context` points to. Throws a fault if its match has not
/// begun.
inline Play& began(void* context) {
    auto& play = *static_cast<Play*>(context);
    if (!play.match) arguments::fault("there is no match yet: match{...} comes first");
    return play;
}

/// Reads a kind of event by its name.
inline EventKind read_kind(lua_State* lua, int index) {
    const auto name = arguments::string(lua, index, "kind");
    const auto kind = event_kind(name);
    if (!kind) arguments::fault("there is no event '", name, "'");
    return *kind;
}

}  // namespace thaum::game::inline scenario
