// game/data/crystal_rules.h: rules of the crystals, of the Lens and of the Great Work (assets/crystal.toml).
#pragma once
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "field/carving_tools.h"

namespace thaum::game {

/// Coupling of a carver's hand to the tool in the crystal.
struct CarvingHandRules {
    double metres_per_metre{};  ///< way of the tool per way of the hand (m/m)
    double in_front{};          ///< distance of the tool from the crystal's middle while the hand rests (m)
    double stiffness{};  ///< stiffness of the spring between hand and tool, limited by the device (N/m)
    double damping{};    ///< damping of that spring, limited by the device (N s/m)
};

/// Feel of the crystal's surface (haptics/volume/volume_feel.h).
struct CrystalSurfaceRules {
    double strength{};  ///< push at which the hand gets through (N)
    double depth{};     ///< depth at which the hand is through (voxels)
    double friction{};  ///< coefficient of friction
};

struct CrystalRules {
    double reach{};  ///< greatest distance from the crystal's middle for work (m, on the ground)
    std::vector<std::string> tool_names;  ///< files of assets/carving in the order of the wand keys
    std::vector<field::Tool> tools;       ///< the tools of these files
    double focus_per_second{};            ///< focus that a tool takes while it is applied (1/s)
    /// Share of its change that a tool makes where that leads away from the key, 0 to 1.
    double against_key{};
    double turning{};  ///< speed at which a carver turns the crystal (rad/s)
    double overlap{};  ///< overlap with the key that gives the Lens, 0 to 1
    CarvingHandRules hand{};
    CrystalSurfaceRules surface{};
    field::Tool chip{};           ///< melts a ball away where a hit strikes
    double chip_burst_reach{};    ///< distance from the crystal's surface within which a burst chips it (m)
    double chip_least_impulse{};  ///< impulse of a thing from which its blow chips the crystal (N s)
    Tick chip_again{};            ///< time between two chips by the same thing
    double lens_share{};          ///< harm of a blast by a wizard with the Lens, relative to one without
    Tick work_lasts{};            ///< time for which both halves of the Great Work must be held
};

/// Reads everything but the tools.
CrystalRules read_crystal_rules(const Config& file);

/// Reports a tool that changes what the crystals of a match do not have. `root` is that of crystal.toml.
void check_crystal_tools(const ConfigTable& root, const CrystalRules& rules);

}  // namespace thaum::game
