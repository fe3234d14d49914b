// game/scenario/detail/prelude.h: verbs (functions of scenario scripts) that are written in Lua, on top of
// those in verbs.cpp.
#pragma once
#include <string_view>

namespace thaum::game::inline scenario {

extern const std::string_view prelude;

}  // namespace thaum::game::inline scenario
