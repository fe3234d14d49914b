// game/data/teams.h: the two teams and the names of their players on the screen. Colour, mark (ring or
// triangle) and robe pattern each identify a team, so colour vision is not needed.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "core/maths.h"
#include "game/components/wizard.h"

namespace thaum::game::inline data {

/// Colours of a team: 0 is ember, 1 is tide.
struct TeamColours {
    /// Colours of the robe's cloth, of its dark parts and of its light parts (linear light, 0 to 1).
    fvec3 cloth, dark, light;
    fvec3 glow;  ///< colour of bolts and of the light that bolts emit
};
const TeamColours& team_colours(std::uint32_t team);
/// Name of a team: "Ember" or "Tide".
std::string_view team_name(std::uint32_t team);

/// Names of the players on the screen; an empty name is replaced by the team's name.
using PlayerNames = std::array<std::string, players>;
/// Returns a player's name on the screen.
std::string_view name_of(const PlayerNames& names, std::uint32_t player);

}  // namespace thaum::game::inline data
