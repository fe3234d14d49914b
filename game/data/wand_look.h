// game/data/wand_look.h: what a wand and its missiles look like, as parts of simple shapes. The table `look`
// of a wand's data file lists the parts. Looks change no match, so they are left out of the hash of the file.
#pragma once
#include <vector>

#include "core/config.h"

namespace thaum::game::inline data {

/// Shapes of the parts of a look.
enum class LookShape : std::uint8_t {
    rod,    ///< cone or cylinder between the points `from` and `to`
    ball,   ///< ellipsoid at `from`
    ring,   ///< flat ring at `from`
    crook,  ///< rod bent upwards along an arc of a circle; starts at `from`
    cage    ///< the team's mark (a ring or a triangle) across each of the three axes; for missiles only
};

/// Colour of a part: fixed, or given by the team.
enum class LookPaint : std::uint8_t {
    fixed,
    glow,  ///< colour of the team's light (TeamColours::glow)
    core   ///< nearly white, with some of the team's light
};

/// One part of a look. Frame: x right, y up, z ahead. The handle of a wand is at z = 0, its tip at z = 0.5 m.
struct LookPart {
    LookShape shape{};
    vec3 from{};          ///< start of a rod or crook, or middle of another part (m)
    vec3 to{};            ///< end of a rod (m)
    double radius{};      ///< radius; for a rod, at its start (m)
    double radius_end{};  ///< radius of a rod's end, or inner radius of a ring (m)
    double thickness{};   ///< thickness of a ring or of a cage's bars (m)
    double bend{};        ///< radius of a crook's arc (m)
    double turn{};        ///< angle of a crook's arc, or of a ring about its axis (rad)
    vec3 stretch{1};      ///< scale of a ball along each axis
    int axis{2};          ///< axis of a ring: 0 for x, 1 for y, 2 for z
    int sides{8};         ///< number of sides; 0: ring with the sides of the team's mark (ring or triangle)
    bool capped{};        ///< true: a ball closes the rod's end
    bool mirrored{};      ///< true: the part appears on both sides, at x and -x
    LookPaint paint{};
    std::uint32_t colour{};  ///< colour as sRGB 0xRRGGBB if `paint` is fixed
    bool operator==(const LookPart&) const = default;
};

/// Look of one wand and of its missiles.
struct WandLook {
    bool flat{};  ///< true: the wand is flat and held at an angle, so that no view shows only its edge
    std::vector<LookPart> wand;
    std::string steady_force = "Pull";  ///< display name of the wand's steady force on the hand
    /// Parts of the missile, which flies towards +z. Missile::size scales them unless it is 0.
    std::vector<LookPart> missile;
    bool operator==(const WandLook&) const = default;
};

/// Reads the table `look`. Reports faults at their keys.
WandLook read_wand_look(const ConfigTable& look);

/// Parses a colour "#RRGGBB" as sRGB 0xRRGGBB; std::nullopt for any other text.
std::optional<std::uint32_t> hex_colour(std::string_view words);

}  // namespace thaum::game::inline data
