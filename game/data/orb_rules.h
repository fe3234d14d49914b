// game/data/orb_rules.h: settings of the scrying orb from assets/orb.toml.
#pragma once
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "field/filters.h"
#include "field/transfer.h"
#include "game/data/effect.h"

namespace thaum::game::inline data {

/// A haptic mode (a way to feel the orb's flow) that a wizard can choose at the orb. Its number is its index
/// in OrbRules::modes.
struct OrbMode {
    std::string name;                    ///< name of a haptic mode (haptics/modes.h)
    std::vector<field::Filter> filters;  ///< filters applied to the orb's flow before the mode reads it
    /// Strength of the mode's force before the wizard changes it, as a function of the mode's property (N).
    /// The property is a quantity of the flow, such as its speed. A derivative of the flow that the mode
    /// itself computes is per metre of hand motion, and OrbRules::metres_per_metre converts it to metres in
    /// the orb. A derivative by one of the filters is per metre in the orb.
    field::TransferFunction strength{};
    field::TransferFunction friction{};  ///< coefficient of friction, as a function of the field's value
    /// Value of the mode's property (a quantity of the flow) at the right end of the plane on which a wizard
    /// draws the strength curve.
    double max_property{};
    /// Strength at the bottom of the drawing plane (N); the plane's left end is the property's value 0.
    double least{};
};

struct OrbRules {
    double metres_per_metre{};  ///< distance that the probe moves per distance of the hand (m/m)
    double reach{};  ///< greatest distance from the orb's surface at which a wizard can use the orb (m)
    /// Distance within which the probe counts as near the hidden core, as a share of the orb's diameter. The
    /// hidden core, which a wizard searches, is the axis of the strongest vortex.
    double core_share{};
    /// time for which the probe must stay near the hidden core until the orb gives its reward (ticks)
    Tick hold{};
    EffectList effects{};  ///< what happens to a wizard who has found the core
    double focus{};        ///< focus (what spells cost) that a wizard spends while searching the orb (1/s)
    /// Stiffness of the spring between the device's tip and the proxy, the point that follows the mode's
    /// rules (N/m, at the device)
    double stiffness{};
    double most{};  ///< strength at the top of the plane on which a wizard draws strength curves (N)
    /// Width of a column of a drawn strength curve, which gets one height for each column; as a share of the
    /// plane's width.
    double column_share{};
    /// Distance that the hand must move after the button Trace is pressed before it draws (m). So a press of
    /// Trace together with a wand key, which casts a spell, draws nothing.
    double begins{};
    std::vector<OrbMode> modes;  ///< all modes, 1 to max_orb_modes of them
};

OrbRules read_orb_rules(const Config& file);

}  // namespace thaum::game::inline data
