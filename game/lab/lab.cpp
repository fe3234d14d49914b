#include "game/lab/lab.h"

#include <algorithm>
#include <cmath>

#include "core/clock.h"
#include "core/file.h"
#include "core/text.h"
#include "fluid/resample.h"
#include "game/data/match_data.h"

namespace thaum::game::inline lab {
namespace {

constexpr double max_gravity = 100;  // largest gravity that a person can set (m/s^2)
// Largest speed at which the ladle acts on the fluid (m/s). Without it, a jump of the mouse would give any
// speed.
constexpr double max_ladle_speed = 8;
constexpr double pour_radius = 0.25;  // radius of a poured cloud (m)

Expected<void> check(const LabSettings& s) {
    if (std::ranges::find(lab_cells, s.cells) == lab_cells.end())
        return fail(text("cells ", s.cells, ": must be 15, 16, 24, 32, 48 or 64"));
    if (!(std::abs(s.gravity) <= max_gravity))
        return fail(text("gravity ", s.gravity, ": must be within ", max_gravity, " m/s^2"));
    return {};
}

/// Copies those settings that a running fluid can adopt.
void put_numbers(const LabSettings& from, fluid::Settings& to) {
    to.viscosity = from.viscosity;
    to.gravity = {0, -from.gravity, 0};
    to.substances.clear();
    for (const Ingredient& i : from.substances) to.substances.push_back(i.substance);
}

/// A brew at rest without ingredients: the match's brew with the lab's grid and settings.
Expected<Brew> brew_of(CauldronRules rules, const LabSettings& settings) {
    rules.cells_across = settings.cells;
    rules.solver = settings.solver;
    auto brew = make_brew(rules, basin_of(settings.room.size, settings.room.filled));
    if (!brew) return brew;
    auto wanted = brew->fluid.settings;
    const auto walls = settings.no_slip ? fluid::Edge::no_slip : fluid::Edge::free_slip;
    wanted.edges = {walls, fluid::Edge::free_slip, walls};
    wanted.order = settings.order;
    wanted.no_slip_at_solids = settings.no_slip;
    if (!settings.bowl || settings.solver == fluid::Solver::classic) wanted.solid = nullptr;
    put_numbers(settings, wanted);
    auto made = fluid::make_fluid(wanted);
    if (!made) return made.error();
    brew->fluid = std::move(*made);
    brew->contents.fill(no_ingredient);
    for (std::uint32_t i = 0; i < settings.substances.size(); ++i) brew->contents[i] = i;
    return brew;
}

/// Whether a fluid can go on under other settings, because its grid, walls and solver stay the same.
bool same_grid(const LabSettings& a, const LabSettings& b) {
    return a.solver == b.solver && a.cells == b.cells && a.order == b.order && a.bowl == b.bowl &&
           a.no_slip == b.no_slip && a.room == b.room && a.substances.size() == b.substances.size();
}

/// Applies the ladle's drag to the fluid, and returns the force (N). The force is limited so that the flow at
/// the ladle does not become faster than the ladle.
double stir(LabState& lab, vec3 to) {
    const vec3 from = lab.ladle.value_or(to);
    const vec3 speed = limited((to - from) / lab_dt, max_ladle_speed);
    const auto& ladle = lab.rules.ladle;
    const double radius = std::max(ladle.radius, 1.5 * lab.brew.fluid.lattice.h);
    const vec3 place = to - lab.brew.corner;
    const vec3 slip = speed - fluid::velocity_at(lab.brew.fluid, place);
    const double taken = std::min(fluid::pushed_volume(radius), ladle.form * lab_dt);
    if (slip == vec3(0) || !fluid::push(lab.brew.fluid, {place, radius, taken * slip})) return 0;
    return lab.rules.density * taken / lab_dt * glm::length(slip);
}

bool is_wet(const LabState& lab, vec3 place) {
    return is_finite(place) && place.y < fluid::height_at(lab.brew.surface, {place.x, place.z});
}

/// Moves the ladle and returns the force of the brew on it (N).
double take_ladle(LabState& lab, const std::optional<vec3>& ladle) {
    const double force = ladle && is_wet(lab, *ladle) ? stir(lab, *ladle) : 0;
    lab.ladle = ladle && is_finite(*ladle) ? ladle : std::nullopt;
    return force;
}

void take_pours(LabState& lab, const std::vector<LabPour>& pours) {
    for (const LabPour& p : pours) {
        if (fluid::pour(lab.brew.fluid, p.substance, p.place - lab.brew.corner, pour_radius, p.amount))
            lab.last_poured = p.substance;
    }
}

fluid::SpringSurfaceStep step_surface(LabState& lab) {
    std::array<fluid::SurfaceProbe, 1> probe{};
    if (lab.ladle) probe[0] = {{lab.ladle->x, lab.ladle->z}, lab.ladle->y, lab.rules.ladle.radius};
    const auto probes = std::span(probe).first(lab.ladle ? 1 : 0);
    return fluid::advance(lab.brew.surface, lab.brew.scratch, probes, lab_dt);
}

/// Calls f, returns its result, and stores the computing time in `us` (us).
template <class F>
auto timed(F&& f, double& us) {
    const auto start = monotonic_ns();
    auto result = f();
    us = static_cast<double>(monotonic_ns() - start) * 1e-3;
    return result;
}

Expected<void> reset(LabState& lab) {
    auto fresh = make_lab(lab.rules, lab.settings);
    if (!fresh) return fresh.error();
    lab = std::move(*fresh);
    return {};
}

}  // namespace

Expected<LabData> load_lab_data(const std::filesystem::path& assets) {
    const auto match = load_match_data(assets, {});
    if (!match) return match.error();
    if (!match->arena.bowl) return fail(text(match->choice.arena, ": it has no bowl"));
    if (!match->cauldron) return fail(text(match->choice.rules, ": it has no cauldron"));
    LabData data{*match->cauldron, {.size = match->arena.bowl->size, .filled = 1}};
    data.room.filled = data.rules.filled;
    return data;
}

LabSettings lab_settings(const LabData& data) {
    const auto& rules = data.rules;
    LabSettings settings{
        .solver = rules.solver, .cells = rules.cells_across, .viscosity = rules.viscosity, .room = data.room};
    const auto count = std::min(rules.ingredients.size(), fluid::max_substances);
    settings.substances.assign(rules.ingredients.begin(),
                               rules.ingredients.begin() + static_cast<std::ptrdiff_t>(count));
    return settings;
}

Expected<LabState> make_lab(const CauldronRules& rules, const LabSettings& settings) {
    if (auto sound = check(settings); !sound) return sound.error();
    auto brew = brew_of(rules, settings);
    if (!brew) return brew.error();
    return LabState{.rules = rules,
                    .settings = settings,
                    .basin = basin_of(settings.room.size, settings.room.filled),
                    .brew = std::move(*brew)};
}

Expected<void> change_lab(LabState& lab, const LabSettings& settings) {
    if (auto sound = check(settings); !sound) return sound;
    auto& fluid = lab.brew.fluid;
    if (same_grid(lab.settings, settings)) {
        auto wanted = fluid.settings;
        put_numbers(settings, wanted);
        if (auto sound = fluid::check(wanted); !sound) return sound;
        fluid.settings = wanted;
        fluid::refresh_after_edit(fluid);  // a fluid at rest whose density has changed must start to move
    } else {
        auto brew = brew_of(lab.rules, settings);
        if (!brew) return brew.error();
        fluid::resample_into(brew->fluid, fluid);
        fluid = std::move(brew->fluid);
        lab.brew.corner = brew->corner;
        lab.brew.contents = brew->contents;
    }
    lab.settings = settings;
    return {};
}

LabFigures figures_of(const LabState& lab) {
    const auto& fluid = lab.brew.fluid;
    LabFigures figures{.momentum = fluid::momentum(fluid)};
    figures.fluid.energy = fluid::energy(fluid);
    for (std::size_t s = 0; s < fluid.state.substances.size(); ++s) figures.amounts[s] = amount(fluid, s);
    if (lab.last_poured < fluid.state.substances.size())
        figures.mixing = fluid::mixing(fluid, lab.last_poured);
    return figures;
}

LabFigures step_lab(LabState& lab, const LabInput& input, Jobs& jobs) {
    std::string refused;
    if (input.change) {
        if (auto changed = change_lab(lab, *input.change); !changed) refused = changed.error().message;
    }
    if (input.reset) {
        if (auto fresh = reset(lab); !fresh) refused = fresh.error().message;
    }
    take_pours(lab, input.pours);
    const double ladle_n = take_ladle(lab, input.ladle);
    fluid::StepReport report;
    double fluid_us = 0, surface_us = 0;
    const auto ticket =
        jobs.run([&] { report = timed([&] { return advance(lab.brew.fluid, lab_dt); }, fluid_us); });
    const auto surface = timed([&] { return step_surface(lab); }, surface_us);
    ticket.wait();
    ++lab.steps;
    LabFigures figures = figures_of(lab);
    figures.fluid = report;
    figures.surface = surface;
    figures.cfl = report.speed * lab_dt / lab.brew.fluid.lattice.h;
    figures.fluid_us = fluid_us;
    figures.surface_us = surface_us;
    figures.ladle_n = ladle_n;
    figures.refused = std::move(refused);
    return figures;
}

}  // namespace thaum::game::inline lab
