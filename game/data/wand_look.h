// game/data/wand_look.h: what a wand and its missiles look like, as parts of simple shapes. The table `look` of
// a wand's data file lists the parts. Looks change no match, so they are left out of the hash of the file.
#pragma once
#include <vector>

#include "core/config.h"

namespace thaum::game {

/// Shapes of parts.
enum class LookShape : std::uint8_t {
    rod,    ///< cone or cylinder from `from` to `to`
    ball,   ///< ellipsoid at `from`
    ring,   ///< flat ring at `from`
    crook,  ///< rod bent upwards in an arc of a circle; starts at `from`
    cage    ///< mark of the team across each axis: rings, or triangles; of missiles only
};

/// Colour of a part: fixed, or given by the team.
enum class LookPaint : std::uint8_t {
    fixed,
    glow,  ///< colour of the team's light
    core   ///< nearly white, with some of the team's light
};

/// One part of a look. Frame: x right, y up, z ahead. The handle of a wand is at z = 0, its tip at z = 0.5 m.
struct LookPart {
    LookShape shape{};
    vec3 from{};          ///< start or middle (m)
    vec3 to{};            ///< end of a rod (m)
    double radius{};      ///< radius, or that of a rod's start (m)
    double radius_end{};  ///< radius of a rod's end, or inner radius of a ring (m)
    double thickness{};   ///< thickness of a ring or of a cage's bars (m)
    double bend{};        ///< radius of a crook's arc (m)
    double turn{};        ///< angle of a crook's arc, or of a ring about its axis (rad)
    vec3 stretch{1};      ///< scale of a ball along each axis
    int axis{2};          ///< axis of a ring: 0, 1, 2
    int sides{8};         ///< number of sides; 0: ring with the sides of the team's mark
    bool capped{};        ///< a ball ends the rod
    bool mirrored{};      ///< the part appears on both sides, at x and -x
    LookPaint paint{};
    std::uint32_t colour{};  ///< colour as sRGB 0xRRGGBB if `paint` is fixed
};

/// Look of one wand and of its missiles.
struct WandLook {
    bool flat{};  ///< the wand is flat and is held turned, so that no view shows it as a mere line
    std::vector<LookPart> wand;
    std::string steady_force = "Pull";  ///< name of the wand's steady force on the hand, for people
    std::vector<LookPart> missile;      ///< flies towards z; scaled by Missile::size unless that is 0
};

/// Reads the table `look`. Reports faults at their keys.
WandLook read_wand_look(const ConfigTable& look);

/// Colour of "#RRGGBB" as sRGB 0xRRGGBB; std::nullopt for other words.
std::optional<std::uint32_t> hex_colour(std::string_view words);

}  // namespace thaum::game
