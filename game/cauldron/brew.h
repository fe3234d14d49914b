// game/cauldron/brew.h: what is in the cauldron, as plain data: a flow, up to three substances in it, and the surface on top. The one
// brew that the match, the lab, scenarios and benchmarks stir.
//
//            level ──── ~~~~~~~~~~~~~ ────      origin of the brew's frame: the middle of the surface, +y up
//                   \               /
//                    \_____________/            the box of cells reaches down to the lowest place of the bowl's inside
#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "fluid/fluid.h"
#include "fluid/sheet.h"
#include "game/arena/solids.h"
#include "game/components/ingredient.h"

namespace thaum::game {

/// What can be dropped in. Colour linear, 0 to 1.
struct Ingredient {
    std::string name;
    vec3 colour{};
    fluid::Substance substance{};
};

struct LadleRules {
    double radius{};              ///< m, of the fluid that it takes along
    double viscous{}, form{};     ///< m, m^3/s: its drag (haptics/fluid_touch.h, equations 1 to 3)
    double height{};              ///< m, of the part that dips in
    double mass{};                ///< kg, of its own
    double stiffness{};           ///< N/m, of the spring that ties it to the hand, and of the wall
    double damping{};             ///< N s/m, likewise
    double metres_per_metre{};    ///< of the ladle for one of the hand
    double newtons_per_newton{};  ///< of the hand for one on the ladle
    double in{},
        below{};     ///< m, where it is for a hand at rest: from the middle to its holder, below the level
    double reach{};  ///< m, from the rim, where its holder may stand
};

/// What the brew does to who is near, and to who stirs.
struct AuraRules {
    double radius{};  ///< m, from the middle
    double thick_above{},
        thick_pace{};  ///< of the pure brew's viscosity; what is left of a walking speed then
    double light_below{}, light_gravity{};  ///< of the pure brew's density; what is left of the weight then
    double refill{};                        ///< energy/s of each wand, of who stirs with the flow
    double refill_speed{};                  ///< m/s, of the flow, at least
};

/// assets/cauldron.toml.
struct CauldronRules {
    int cells_across{};
    fluid::Solver solver{};
    double filled{};                 ///< of the bowl's height
    double density{};                ///< kg/m^3, what a push has to move
    double viscosity{};              ///< m^2/s, of the base fluid
    vec3 colour{};                   ///< likewise
    fluid::SheetSettings surface{};  ///< its side follows from the bowl
    LadleRules ladle{};
    AuraRules aura{};
    double drop_amount{}, drop_radius{};  ///< m^3, m: of an ingredient that is dropped in
    double recoil{};                      ///< N s, of that on the ladle
    Tick recoil_length{};
    double burst{};                     ///< N s, of a lob that bursts at the brew
    double wrest_least{};               ///< J within a second and a half
    Tick spoils_after{};                ///< the first ingredient
    double spoil_push{}, spoil_harm{};  ///< m/s, HP
    double niche_radius{};              ///< m
    Tick niche_again{};
    std::vector<Ingredient> ingredients;
};

CauldronRules read_cauldron_rules(const Config& file);

/// The inside of a bowl below the level of what is in it.
struct Basin {
    double radius{};  ///< m, the widest
    double depth{};   ///< m, the deepest
    std::vector<vec2>
        profile;  ///< m: radius and height (0: level, below it negative), from the level down to the middle
};

/// m: the level of what fills a bowl, above the bowl's middle.
inline double level_of(const BowlSize& bowl, double filled) { return bowl.height * (filled - 0.5); }

Basin basin_of(const BowlSize& bowl, double filled);

/// m: how far a way leads to the side.
inline double off_axis(vec3 way) { return std::sqrt(way.x * way.x + way.z * way.z); }

/// m: how wide the basin is at a height (negative: below the level); 0 below its floor. Above the level as wide as there.
double width_at(const Basin& basin, double height);

/// Which ingredient stands in each substance.
using Contents = std::array<std::uint32_t, fluid::substances_most>;

struct Brew {
    fluid::Fluid fluid;
    fluid::Sheet sheet;
    fluid::SheetScratch scratch;
    Contents what{no_ingredient, no_ingredient, no_ingredient};
    vec3
        corner{};  ///< m, brew's frame: where the fluid's box begins; a place p of the brew is p - corner of the fluid
};

/// What make_brew makes it of; the rules must be checked ones.
fluid::Settings brew_settings(const CauldronRules& rules, const Basin& basin);
fluid::SheetSettings brew_surface(const CauldronRules& rules, const Basin& basin);

/// At rest and pure. The error says what of the rules the solver does not take.
Expected<Brew> make_brew(const CauldronRules& rules, const Basin& basin);

/// The substance in which an ingredient stands, or the first free one; none where all are taken.
std::optional<std::size_t> substance_for(const Contents& what, std::uint32_t ingredient);

/// From now on the ingredient stands in that substance.
void assign(Brew& brew, const CauldronRules& rules, std::size_t substance, std::uint32_t ingredient);

/// `amount`, m^3, of an ingredient within `radius` of a place of the brew's frame. False where nothing was added.
bool drop(Brew& brew, const CauldronRules& rules, std::uint32_t ingredient, vec3 place, double radius,
          double amount);

}  // namespace thaum::game
