// game/data/cauldron_rules.h: the settings of the cauldron and of its brew, from assets/cauldron.toml.
#pragma once
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "fluid/fluid.h"
#include "fluid/spring_surface.h"
#include "game/arena/basin.h"

namespace thaum::game::inline data {

/// How an ingredient lies in its niche, where players get it, and in a hand. Each shape is different, so that
/// ingredients are recognised without their colour.
enum class IngredientShape : std::uint8_t { heap, crystals, ingots, drops, feathers, cloud, cushion };
inline constexpr std::size_t ingredient_shapes = 7;

/// A substance that a player can drop into the brew. The colour is linear light, 0 to 1.
struct Ingredient {
    std::string name;
    vec3 colour{};
    IngredientShape shape{};  ///< shape of the ingredient, for pictures only
    fluid::Substance substance{};
};

/// The ladle and its coupling to the hand.
struct LadleRules {
    double radius{};           ///< radius of the ball of fluid that the ladle carries along (m)
    double viscous{}, form{};  ///< drag coefficients of haptics/fluid_touch.h, equations 1 to 3 (m, m^3/s)
    double height{};           ///< length of the part of the ladle that dips into the brew (m)
    double mass{};             ///< mass of the ladle itself (kg)
    double stiffness{};  ///< stiffness of the spring between ladle and hand, and of the bowl's wall (N/m)
    double damping{};    ///< damping of the spring between ladle and hand, and of the bowl's wall (N s/m)
    double metres_per_metre{};    ///< distance that the ladle moves per distance of the hand (m/m)
    double newtons_per_newton{};  ///< force on the hand per force on the ladle (N/N)
    /// Rest position of the ladle: distance from the middle towards the wizard, and depth below the surface
    /// (m).
    double in{}, below{};
    double reach{};  ///< greatest distance from the rim at which a wizard can stir (m)
};

/// Effects of the brew on wizards near it and on players who stir it.
struct AuraRules {
    double radius{};  ///< distance from the middle within which the effects act (m)
    /// `thick_above`: multiple of the pure brew's viscosity above which a brew is thick. `thick_pace`:
    /// fraction of the full speed at which wizards walk near a thick brew.
    double thick_above{}, thick_pace{};
    /// `light_below`: fraction of the pure brew's density below which a brew is light. `light_gravity`:
    /// fraction of their weight that wizards keep near a light brew.
    double light_below{}, light_gravity{};
    double refill{};  ///< energy that each wand gains while its wizard stirs in the direction of the flow
                      ///< (1/s)
    double refill_speed{};  ///< minimum speed of the flow that refills wands (m/s)
};

/// Reward for keeping a brew well mixed, called the boon: it heals the brew's owner. Each brew gives it once.
struct BoonRules {
    double mixed{};    ///< evenness (Cauldron::mixing) from which on the brew counts as well mixed, 0 to 1
    Tick after{};      ///< time for which one owner must keep the brew well mixed (ticks)
    Tick lasts{};      ///< duration of the healing (ticks)
    double healing{};  ///< health that the owner gains near the bowl, up to the start value (HP/s)
};

/// Settings from assets/cauldron.toml.
struct CauldronRules {
    int cells_across{};
    fluid::Solver solver{};
    double filled{};     ///< level of the brew as a fraction of the bowl's height
    double density{};    ///< density of the pure brew, for momentum (kg/m^3)
    double viscosity{};  ///< kinematic viscosity of the base fluid (m^2/s)
    vec3 colour{};       ///< colour of the base fluid, linear light, 0 to 1
    /// Settings of the brew's spring surface. Its width `side` is not read from the file but computed from
    /// the bowl.
    fluid::SpringSurfaceSettings surface{};
    LadleRules ladle{};
    AuraRules aura{};
    BoonRules boon{};
    double drop_amount{}, drop_radius{};  ///< volume and radius of a dropped ingredient (m^3, m)
    double recoil{};                      ///< momentum that a dropped ingredient gives to the ladle (N s)
    Tick recoil_length{};
    /// Downward momentum of a lob (a missile thrown in an arc) that bursts at the brew (N s)
    double burst{};
    /// Least work that a wizard must do on the other player's brew within 1.5 s, with the ladle, to take the
    /// brew over (J).
    double min_wrest{};
    Tick spoils_after{};  ///< time from the first ingredient to boiling over (ticks)
    /// Time from the first ingredient to boiling over, for a brew that can no longer become a potion (ticks)
    Tick useless_spoils_after{};
    /// Effect of a brew that boils over on wizards at the rim: speed of the push (m/s), and harm (HP)
    double spoil_push{}, spoil_harm{};
    double niche_radius{};  ///< greatest distance at which a wizard picks up an ingredient (m)
    Tick niche_again{};
    Tick put_back{};  ///< time after which an ingredient that was put away is back in its niche (ticks)
    std::vector<Ingredient> ingredients;
};

CauldronRules read_cauldron_rules(const Config& file);

/// Settings of the fluid and of the surface in a basin (brew/brew.h). The rules must have been checked.
fluid::Settings brew_settings(const CauldronRules& rules, const Basin& basin);
fluid::SpringSurfaceSettings brew_surface(const CauldronRules& rules, const Basin& basin);

/// Position of the corner at which the fluid's grid begins (m, brew's frame).
vec3 brew_corner(const fluid::Settings& settings);

/// Checks that the fluid solver accepts these rules for this basin, without making a brew, which takes long.
/// The error names the setting that the solver rejects.
Expected<void> check_brew(const CauldronRules& rules, const Basin& basin);
}  // namespace thaum::game::inline data
