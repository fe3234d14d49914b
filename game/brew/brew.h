// game/brew/brew.h: the contents of the cauldron as plain data: a flow, up to three substances, and the
// surface on top. The match, the lab, scenarios and benchmarks all use it.
//
//            level ──── ~~~~~~~~~~~~~ ────   origin of the brew's frame: middle of the surface, +y up
//                   \               /
//                    \_____________/         the box of cells reaches down to the bowl's lowest inside point
#pragma once
#include <array>
#include <optional>

#include "core/error.h"
#include "fluid/fluid.h"
#include "fluid/spring_surface.h"
#include "game/arena/basin.h"
#include "game/components/ingredient.h"
#include "game/data/cauldron_rules.h"

namespace thaum::game::inline brew {

/// For each substance of the fluid (a concentration that the flow carries), the number of the ingredient that
/// it stands for.
using Contents = std::array<std::uint32_t, fluid::max_substances>;

struct Brew {
    fluid::Fluid fluid;
    fluid::SpringSurface surface;
    fluid::SpringSurfaceScratch scratch;
    Contents contents{no_ingredient, no_ingredient, no_ingredient};
    /// Origin of the box in which the fluid is computed (m, brew's frame). A point p of the brew is p -
    /// corner in the fluid's frame.
    vec3 corner{};
};

/// Makes a brew at rest without ingredients. The error names the setting that the fluid's solver rejects.
Expected<Brew> make_brew(const CauldronRules& rules, const Basin& basin);

/// Returns the substance of the fluid that stands for the ingredient. If there is none, returns the first one
/// that stands for no ingredient yet; std::nullopt if all stand for others.
std::optional<std::size_t> substance_for(const Contents& contents, std::uint32_t ingredient);

/// Makes a substance of the fluid stand for this ingredient from now on.
void assign(Brew& brew, const CauldronRules& rules, std::size_t substance, std::uint32_t ingredient);

/// Adds `amount` (m^3) of an ingredient within `radius` (m) of `place` (m, brew frame). Returns false if
/// nothing was added.
bool drop(Brew& brew, const CauldronRules& rules, std::uint32_t ingredient, vec3 place, double radius,
          double amount);

}  // namespace thaum::game::inline brew
