// physics/detail/checks.h: checks of descriptions and states. An impossible value fails an assertion that
// names the body.
#pragma once
#include <string>

#include "physics/physics.h"

namespace thaum::physics::detail {

/// Message about a body, such as "body 7: unknown".
std::string about(Key key, const char* what);
void check_state(Key, const BodyState&);
void check_desc(Key, const BodyDesc&, std::size_t meshes);

/// Distance of the farthest point of the shape from its centre; infinite for a mesh (m).
double reach_of(const BodyDesc&);

}  // namespace thaum::physics::detail
