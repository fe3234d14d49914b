// game/data/crystal_rules.h: rules of the crystals, of the Lens and of the Great Work (assets/crystal.toml).
#pragma once
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "field/carving_tools.h"

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
    double focus_per_second{};            ///< focus that a tool takes while it is applied (1/s)
    /// Share that remains of a tool's change where the change leads away from the key, the shape to be
    /// carved, 0 to 1.
    double against_key{};
    double turning{};  ///< speed at which a carver turns the crystal (rad/s)
    /// Overlap with the key (the shape to be carved) at which the wizard gains the reward, the Lens; 0 to 1
    double overlap{};
    CarvingHandRules hand{};
    CrystalSurfaceRules surface{};
    field::Tool chip{};           ///< tool that melts a ball of the crystal at the point of a hit
    double chip_burst_reach{};    ///< distance from the crystal's surface within which a burst chips it (m)
    double chip_least_impulse{};  ///< minimum impulse of a thing whose blow chips the crystal (N s)
    Tick chip_again{};            ///< time after a hit in which no thing chips the same crystal (ticks)
    double lens_share{};          ///< harm of a blast by a wizard with the Lens, relative to one without it
    Tick work_lasts{};  ///< time for which a wizard must hold both Azoth and the Lens to win (ticks)
};

/// Reads all rules except the tools, which have files of their own.
CrystalRules read_crystal_rules(const Config& file);

/// Reports a tool that changes a property which crystals of a match lack. `root`: the root table of
/// crystal.toml.
void check_crystal_tools(const ConfigTable& root, const CrystalRules& rules);

}  // namespace thaum::game::inline data
