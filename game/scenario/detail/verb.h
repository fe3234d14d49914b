// game/scenario/detail/verb.h: what all files of verbs share, and the lists in which they name their own.
#pragma once
#include <span>

#include "game/scenario/detail/arguments.h"
#include "game/scenario/play.h"
#include "game/scenario/sandbox.h"

namespace thaum::game {

/// A name that begins with raw_ is taken by the prelude, and gone when a script begins.
struct VerbName {
    const char* name;
    Sandbox::Verb verb;
};

std::span<const VerbName> thing_verbs();
std::span<const VerbName> report_verbs();
std::span<const VerbName> brew_verbs();

// What the physics can bear, whatever a script asks for.
inline constexpr double farthest = 500;  ///< m
inline constexpr double fastest = 200;   ///< m/s

/// The play that is a verb's context, with a match.
inline Play& began(void* context) {
    auto& play = *static_cast<Play*>(context);
    if (!play.match) arguments::fault("there is no match yet: match{...} comes first");
    return play;
}

inline const ecs::World& world_of(const Play& play) { return play.match->world(); }

}  // namespace thaum::game
