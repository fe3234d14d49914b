#include "game/data/cauldron_rules.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/colour.h"
#include "core/text.h"

namespace thaum::game::inline data {
namespace {

constexpr Range viscosity{0, fluid::max_viscosity};
const std::vector<std::string_view> solver_names{"thaum", "classic"};

/// Reads the settings of the brew's surface, except its width `side`, which brew_surface computes from the
/// bowl.
fluid::SpringSurfaceSettings read_spring_surface(const ConfigTable& table) {
    fluid::SpringSurfaceSettings result;
    result.nodes = static_cast<std::uint32_t>(table.integer("nodes", {3, 129}));
    result.tension = table.number("tension_n_per_m", {0, 1e6});
    result.areal_mass = table.number("areal_mass_kg_m2", {0.1, 1e6});
    result.level = table.number("level_n_per_m3", {0, 1e6});
    result.damping = table.number("damping_per_s", {0, 1e3});
    result.contact = table.number("contact_n_per_m", {0, 1e6});
    result.pop_through = table.number("pop_through_n", {0, 1e6});
    result.cling = table.number("cling_n", {0, 1e6});
    result.reach = table.number("reach_m", {1e-3, 100});
    return result;
}

LadleRules read_ladle(const ConfigTable& table) {
    return {.radius = table.number("radius_m", {0.01, 2}),
            .viscous = table.number("viscous_m", {0, 100}),
            .form = table.number("form_m3_per_s", {0, 100}),
            .height = table.number("height_m", {0.01, 2}),
            .mass = table.number("mass_kg", {0, 100}),
            .stiffness = table.number("stiffness_n_per_m", {1, 1e5}),
            .damping = table.number("damping_n_s_per_m", {0, 1e4}),
            .metres_per_metre = table.number("metres_per_metre", {0.1, 1000}),
            .newtons_per_newton = table.number("newtons_per_newton", {1e-6, 1}),
            .in = table.number("in_from_middle_m", {0, 10}),
            .below = table.number("below_surface_m", {-5, 5}),
            .reach = table.number("reach_m", {0, 10})};
}

AuraRules read_aura(const ConfigTable& table) {
    return {.radius = table.number("radius_m", {0, 100}),
            .thick_above = table.number("thick_above", {1, 1e6}),
            .thick_pace = table.number("thick_pace", {0.1, 1}),
            .light_below = table.number("light_below", {0, 1}),
            .light_gravity = table.number("light_gravity", {0, 1}),
            .refill = table.number("refill_per_s", {0, 1e6}),
            .refill_speed = table.number("refill_speed_m_s", {0, 100})};
}

BoonRules read_boon(const ConfigTable& table) {
    return {.mixed = table.number("mixed", {0, 1}),
            .after = ticks(table.number("after_s", {0, 3600})),
            .lasts = ticks(table.number("lasts_s", {0, 3600})),
            .healing = table.number("health_per_s", {0, 1e4})};
}

void read_brewing(const ConfigTable& table, CauldronRules& rules) {
    rules.drop_amount = table.number("drop_m3", {0, 10});
    rules.drop_radius = table.number("drop_radius_m", {0.01, 2});
    rules.recoil = table.number("recoil_n_s", {0, 1e3});
    rules.recoil_length = ticks(table.number("recoil_s", {0.001, 1}));
    rules.burst = table.number("burst_n_s", {0, 1e5});
    rules.min_wrest = table.number("wrest_least_j", {0, 1e6});
    rules.spoils_after = rules.useless_spoils_after = ticks(table.number("spoils_after_s", {0.1, 3600}));
    rules.spoil_push = table.number("spoil_push_m_s", {0, 100});
    rules.spoil_harm = table.number("spoil_harm", {0, 1e6});
    rules.niche_radius = table.number("niche_radius_m", {0.1, 5});
    rules.niche_again = ticks(table.number("niche_again_s", {0, 3600}));
    rules.put_back = ticks(table.number("put_back_s", {0, 3600}));
}

/// `look` has the ingredient's shape under its name. Shapes are in a table of their own, because the log
/// hashes the table of ingredients and shapes change no match.
Ingredient read_ingredient(const ConfigTable& table, const ConfigTable& look) {
    const std::vector<std::string_view> shapes{"heap",     "crystals", "ingots", "drops",
                                               "feathers", "cloud",    "cushion"};
    const auto name = table.string("name");
    return {.name = name,
            .colour = read_linear_colour(table, "colour"),
            .shape = static_cast<IngredientShape>(look.choice(name, shapes, 0)),
            .substance = {.viscosity = table.number("viscosity_m2_s", viscosity),
                          .weight = table.number("weight", {-1, 10}),
                          .diffusion = table.number("diffusion_m2_s", {0, 1})}};
}

}  // namespace

CauldronRules read_cauldron_rules(const Config& file) {
    const auto root = file.root();
    const auto brew = root.table("brew");
    CauldronRules rules{
        .cells_across = static_cast<int>(brew.integer("cells_across", {6, 128})),
        .solver = brew.choice("solver", solver_names) == 0 ? fluid::Solver::thaum : fluid::Solver::classic,
        .filled = brew.number("filled", {0.3, 1}),
        .density = brew.number("density_kg_m3", {1e-3, 1e5}),
        .viscosity = brew.number("viscosity_m2_s", viscosity),
        .colour = read_linear_colour(brew, "colour"),
        .surface = read_spring_surface(root.table("surface")),
        .ladle = read_ladle(root.table("ladle")),
        .aura = read_aura(root.table("aura")),
        .boon = read_boon(root.table("boon")),
        .ingredients = {}};
    read_brewing(root.table("brewing"), rules);
    const auto look = root.table("look");
    for (const auto& table : root.tables("ingredient")) {
        auto read = read_ingredient(table, look);
        if (std::ranges::find(rules.ingredients, read.name, &Ingredient::name) != rules.ingredients.end())
            table.report("name", text("there are two ingredients '", read.name, "'"));
        rules.ingredients.push_back(std::move(read));
    }
    if (rules.ingredients.empty()) root.report("ingredient", "there must be an ingredient at least");
    return rules;
}

vec3 brew_corner(const fluid::Settings& settings) {
    return -0.5 * settings.h * vec3(settings.cells[0], 2 * settings.cells[1], settings.cells[2]);
}

fluid::Settings brew_settings(const CauldronRules& rules, const Basin& basin) {
    const double h = 2 * basin.radius / rules.cells_across;
    const int deep = std::max(1, static_cast<int>(std::ceil(basin.depth / h - 1e-9)));
    fluid::Settings settings{.solver = rules.solver,
                             .cells = {rules.cells_across, deep, rules.cells_across},
                             .h = h,
                             .edges = {fluid::Edge::no_slip, fluid::Edge::free_slip, fluid::Edge::no_slip},
                             .viscosity = rules.viscosity,
                             .substances = std::vector<fluid::Substance>(fluid::max_substances)};
    const auto walls = std::make_shared<const Basin>(basin);
    settings.solid = [walls, corner = brew_corner(settings)](vec3 place) {
        const vec3 at = place + corner;
        return off_axis(at) < width_at(*walls, at.y) ? 0.0 : 1.0;
    };
    return settings;
}

fluid::SpringSurfaceSettings brew_surface(const CauldronRules& rules, const Basin& basin) {
    auto surface = rules.surface;
    surface.side = 2 * basin.radius;
    return surface;
}

Expected<void> check_brew(const CauldronRules& rules, const Basin& basin) {
    if (const auto fluid = fluid::check(brew_settings(rules, basin)); !fluid) return fluid.error();
    if (const auto surface = fluid::checked(brew_surface(rules, basin)); !surface) return surface.error();
    return {};
}

}  // namespace thaum::game::inline data
