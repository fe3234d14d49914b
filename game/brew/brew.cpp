#include "game/brew/brew.h"

#include <algorithm>
#include <utility>

namespace thaum::game::inline brew {

Expected<Brew> make_brew(const CauldronRules& rules, const Basin& basin) {
    if (const auto sound = check_brew(rules, basin); !sound) return sound.error();
    auto fluid = fluid::make_fluid(brew_settings(rules, basin));
    if (!fluid) return fluid.error();
    const vec3 corner = brew_corner(fluid->settings);
    Brew brew{.fluid = std::move(*fluid),
              .surface = fluid::make_spring_surface(brew_surface(rules, basin)),
              .scratch = {},
              .corner = corner};
    // A step of no time sizes the working memory, so that the first stir of a match does not allocate.
    fluid::advance(brew.surface, brew.scratch, {}, 0);
    return brew;
}

std::optional<std::size_t> substance_for(const Contents& contents, std::uint32_t ingredient) {
    for (const auto wanted : {ingredient, no_ingredient}) {
        const auto found = std::find(contents.begin(), contents.end(), wanted);
        if (found != contents.end()) return static_cast<std::size_t>(found - contents.begin());
    }
    return std::nullopt;
}

void assign(Brew& brew, const CauldronRules& rules, std::size_t substance, std::uint32_t ingredient) {
    brew.contents[substance] = ingredient;
    brew.fluid.settings.substances[substance] = rules.ingredients[ingredient].substance;
}

bool drop(Brew& brew, const CauldronRules& rules, std::uint32_t ingredient, vec3 place, double radius,
          double amount) {
    const auto substance = substance_for(brew.contents, ingredient);
    if (!substance || ingredient >= rules.ingredients.size()) return false;
    assign(brew, rules, *substance, ingredient);
    return fluid::pour(brew.fluid, *substance, place - brew.corner, radius, amount);
}

}  // namespace thaum::game::inline brew
