// game/hud/brew_flow.h: a brew's flow as arrows and streamlines.
#pragma once
#include "game/hud/brew_look.h"

namespace thaum::game {

/// Follows the flow from a place for `length` m, in equal steps of about `step` m of way, by the classical Runge-Kutta method;
/// ends early where nothing moves. The place comes first. m in the fluid's frame.
void follow(const BrewPicture& picture, vec3 from, double length, double step, std::vector<vec3>& out);

void add_arrows(const BrewPicture& picture, const BrewPlace& place, const BrewMeshes& meshes,
                std::vector<render::Instance>& out);
/// From fixed seeds, up to 1.6 m each; a line fades into the brew towards its tail, so that it tells which way the flow goes.
void add_streamlines(const BrewPicture& picture, const BrewPlace& place, const BrewMeshes& meshes,
                     std::vector<render::Instance>& out);

}  // namespace thaum::game
