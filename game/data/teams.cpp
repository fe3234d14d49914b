#include "game/data/teams.h"

#include "core/colour.h"

namespace thaum::game::inline data {
namespace {

fvec3 colour(std::uint32_t hex) { return fvec3(linear_colour(hex)); }

}  // namespace

const TeamColours& team_colours(std::uint32_t team) {
    static const std::array teams{
        TeamColours{colour(0xD8541C), colour(0x7A2410), colour(0xFFC070), colour(0xFF8A30)},
        TeamColours{colour(0x2470C8), colour(0x143468), colour(0x9AD8FF), colour(0x40A8FF)}};
    return teams[team == 1 ? 1 : 0];
}

std::string_view team_name(std::uint32_t team) { return team == 0 ? "Ember" : "Tide"; }

std::string_view name_of(const PlayerNames& names, std::uint32_t player) {
    return names[player].empty() ? team_name(player) : std::string_view(names[player]);
}

}  // namespace thaum::game::inline data
