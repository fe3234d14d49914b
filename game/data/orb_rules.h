// game/data/orb_rules.h: settings of the scrying orb from assets/orb.toml.
#pragma once
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "field/filters.h"
#include "field/transfer.h"

namespace thaum::game {

/// A haptic mode that a wizard can put on for the orb. Its number is its place in OrbRules::modes.
struct OrbMode {
    std::string name;                    ///< name of a haptic mode (haptics/modes.h)
    std::vector<field::Filter> filters;  ///< between the orb's flow and the mode
    /// Strength at first, by the mode's property (N). A derivative that the mode itself reads is per metre of the hand.
    /// One metre of the hand is OrbRules::metres_per_metre in the orb. A derivative by a filter is per metre of the orb.
    field::TransferFunction strength{};
    field::TransferFunction friction{};  ///< coefficient of friction, by the field's value
    double most_property{};              ///< property at the right end of the sheet on which a wizard draws
    double least{};  ///< strength at the bottom of that sheet (N); 0 at its left end is property 0
};

struct OrbRules {
    double metres_per_metre{};  ///< distance that the probe moves for each metre of the hand
    double reach{};             ///< greatest distance from the orb's surface at which a wizard can scry (m)
    /// Distance of the probe from the hidden core within which it is near, as a share of the orb's diameter.
    double core_share{};
    Tick hold{};            ///< time for which the probe must stay near the core until the orb tells
    double healing{};       ///< health that a wizard to whom the orb tells gains (HP)
    double focus{};         ///< focus that scrying costs (1/s)
    double stiffness{};     ///< stiffness of the spring between tip and proxy (N/m, at the device)
    double most{};          ///< strength at the top of the sheet on which a wizard draws (N)
    double column_share{};  ///< width of a column of a drawn curve, as a share of the sheet
    double begins{};        ///< way of the hand from which on it draws, so that a key chord draws nothing (m)
    std::vector<OrbMode> modes;  ///< 1 to most_orb_modes
};

OrbRules read_orb_rules(const Config& file);

}  // namespace thaum::game
