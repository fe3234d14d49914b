// game/data/crystal_rules.h: rules of the crystals that wizards carve, of the reward for that (the Lens), and
// of the Great Work, which wins a round (assets/crystal.toml).
#pragma once
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "field/carving_tools.h"
#include "game/data/effect.h"

namespace thaum::game::inline data {

/// Coupling of a carver's hand to the tool in the crystal.
struct CarvingHandRules {
    double metres_per_metre{};  ///< displacement of the tool per displacement of the hand (m/m)
    double in_front{};          ///< distance of the tool from the crystal's middle while the hand rests (m)
    double stiffness{};  ///< stiffness of the spring between hand and tool, limited by the device (N/m)
    double damping{};    ///< damping of the spring between hand and tool, limited by the device (N s/m)
};

/// Feel of the crystal's surface (haptics/volume/volume_feel.h).
struct CrystalSurfaceRules {
    double strength{};  ///< force at which the hand breaks through the surface (N)
    double depth{};     ///< depth at which the hand has broken through (voxels)
    double friction{};  ///< coefficient of friction of the surface
};

struct CrystalRules {
    /// Maximum distance from the crystal's middle at which a wizard can carve (m, along the ground)
    double reach{};
    std::vector<std::string> tool_names;  ///< files of assets/carving in the order of the wand keys
    std::vector<field::Tool> tools;       ///< the tools read from the files in `tool_names`
    /// focus (what spells cost) that a carving tool takes while it is applied (1/s)
    double focus_per_second{};
    /// Share that remains of a tool's change where the change leads away from the key, the shape to be
    /// carved, 0 to 1.
    double against_key{};
    double turning{};  ///< speed at which a carver turns the crystal (rad/s)
    /// Overlap with the key (the shape to be carved) at which the wizard gains the reward; 0 to 1
    double overlap{};
    EffectList effects{};  ///< the reward: what happens to the wizard who has carved the key
    CarvingHandRules hand{};
    CrystalSurfaceRules surface{};
    field::Tool chip{};         ///< tool that melts a ball of the crystal at the point of a hit
    double chip_burst_reach{};  ///< distance from the crystal's surface within which a burst chips it (m)
    /// minimum impulse of the blow of a loose thing that chips the crystal (N s)
    double chip_least_impulse{};
    /// time after a hit by a thing in which the same crystal is not chipped by any thing (ticks)
    Tick chip_again{};
    /// factor on the harm that the wand blast does in the hands of a wizard with the Lens, the reward for
    /// carving
    double lens_share{};
    /// time for which a wizard must hold both halves of the Great Work, Azoth (a potion) and the Lens, to win
    /// (ticks)
    Tick work_lasts{};
};

/// Reads all rules except the tools, which have files of their own.
CrystalRules read_crystal_rules(const Config& file);

/// Reports a tool that changes a property of the material which the crystals of a match do not have. `root`:
/// the root table of crystal.toml.
void check_crystal_tools(const ConfigTable& root, const CrystalRules& rules);

}  // namespace thaum::game::inline data
