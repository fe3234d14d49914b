#include "game/stations/cauldron/cauldron.h"

#include <algorithm>
#include <limits>

#include "core/assert.h"
#include "core/threads.h"
#include "game/brew/brew_state.h"

namespace thaum::game::inline stations {
namespace {

/// Indices of all cells with their middle inside the basin.
std::vector<std::uint32_t> wet_cells(const Brew& brew, const Basin& basin) {
    const auto& lattice = brew.fluid.lattice;
    std::vector<std::uint32_t> cells;
    fluid::each_cell(lattice, [&](int i, int j, int k, std::size_t at) {
        const vec3 place = brew.corner + lattice.h * (vec3(i, j, k) + 0.5);
        if (off_axis(place) < width_at(basin, place.y)) cells.push_back(static_cast<std::uint32_t>(at));
    });
    return cells;
}

double mean_of(const BrewWork& work, const fluid::Samples& samples) {
    double sum = 0;
    for (const auto cell : work.wet) sum += samples[cell];
    return sum / static_cast<double>(work.wet.size());
}

double mean_speed(const BrewWork& work) {
    const auto& velocity = work.brew.fluid.state.velocity;
    double sum = 0;
    for (const auto cell : work.wet)
        sum += glm::length(vec3(velocity[0][cell], velocity[1][cell], velocity[2][cell]));
    return sum / static_cast<double>(work.wet.size());
}

/// Share of the cells inside the basin in which a substance has at least a quarter of its mean density.
double reached_share(const BrewWork& work, const fluid::Samples& samples) {
    constexpr double quarter = 0.25;
    const double least = quarter * mean_of(work, samples);
    if (!(least > 0)) return 0;
    const auto count = std::count_if(work.wet.begin(), work.wet.end(), [&](std::uint32_t cell) {
        return static_cast<double>(samples[cell]) >= least;
    });
    return static_cast<double>(count) / static_cast<double>(work.wet.size());
}

BrewFigures figures_of(const BrewWork& work) {
    BrewFigures figures;
    const auto& fluid = work.brew.fluid;
    double viscosity = fluid.settings.viscosity;
    std::optional<std::size_t> newest;
    for (std::size_t s = 0; s < work.brew.contents.size(); ++s) {
        if (work.brew.contents[s] == no_ingredient) continue;
        const double mean = mean_of(work, fluid.state.substances[s]);
        viscosity += fluid.settings.substances[s].viscosity * mean;
        figures.density += fluid.settings.substances[s].weight * mean;
        newest = s;
    }
    if (newest) {
        figures.mixing = fluid::mixing(fluid, *newest);
        figures.reached = reached_share(work, fluid.state.substances[*newest]);
    }
    figures.viscosity = work.viscosity > 0 ? viscosity / work.viscosity : 1;
    figures.density *= work.density;
    figures.speed = mean_speed(work);
    return figures;
}

bool does_something(const Strokes& strokes) {
    return std::any_of(strokes.list.begin(), strokes.list.begin() + strokes.count,
                       [](const Stroke& s) { return s.ingredient != no_ingredient || s.impulse != vec3(0); });
}

void apply(const CauldronRules& rules, const ChangedBrew& changes, const Strokes& strokes, Brew& brew) {
    for (std::uint32_t i = 0; i < strokes.count; ++i) {
        const auto& stroke = strokes.list[i];
        if (stroke.ingredient != no_ingredient) {
            drop(brew, rules, stroke.ingredient, stroke.place, stroke.radius, stroke.amount);
        } else if (stroke.impulse != vec3(0)) {
            fluid::push(brew.fluid, {stroke.place - brew.corner, stroke.radius,
                                     stroke.impulse / (rules.density * changes.density)});
        }
    }
}

/// Gives the solver the properties of the pure brew, with the factors of a potion that has changed it.
void apply_changes(const CauldronRules& rules, const ChangedBrew& changes, Brew& brew) {
    brew.fluid.settings.viscosity = rules.viscosity * changes.viscosity;
    brew.surface.settings.tension = rules.surface.tension * changes.elasticity;
}

/// Starts the fluid step, with the pushes and ingredients (strokes) that are in `cauldron.current`.
void begin_step(const MatchData& data, BrewSolver& solver, Cauldron& cauldron) {
    auto& work = *solver.work;
    const auto& rules = *data.cauldron;
    const auto& changes = changes_of(data, cauldron);
    apply_changes(rules, changes, work.brew);
    apply(rules, changes, cauldron.current, work.brew);
    cauldron.contents = work.brew.contents;
    cauldron.step_running = 1;
    work.viscosity = rules.viscosity;
    work.density = changes.density;
    work.team.open();
    solver.jobs.run(work.step);
    if (solver.jobs.threads() > 1 && processors() > 1) solver.jobs.run(work.help);
}

/// Waits until the fluid step has ended, and helps with it meanwhile if there is a processor for that.
void wait_for_step(BrewWork& work) {
    if (!work.step.ended() && processors() > 1) work.team.help();
    work.step.wait();
    work.help.wait();
}

void end_step(ecs::World& world, BrewWork& work, Cauldron& cauldron, Tick tick) {
    wait_for_step(work);
    cauldron.step_running = 0;
    cauldron.newest ^= 1U;
    cauldron.stepped = tick;
    cauldron.mixing = work.figures.mixing;
    cauldron.reached = work.figures.reached;
    cauldron.viscosity = work.figures.viscosity;
    cauldron.density = work.figures.density;
    cauldron.speed = work.figures.speed;
    write_fluid(world, cauldron.newest, work.brew.fluid);
}

/// Removes all ingredients. The flow of the pure brew is kept.
void pour_away(Brew& brew) {
    brew.contents.fill(no_ingredient);
    for (auto& samples : brew.fluid.state.substances) std::fill(samples.begin(), samples.end(), 0.0F);
    std::fill(brew.fluid.settings.substances.begin(), brew.fluid.settings.substances.end(),
              fluid::Substance{});
}

void step_fluid(MatchContext& context, BrewSolver& solver, Cauldron& cauldron, Tick tick) {
    auto& work = *solver.work;
    if (cauldron.step_running != 0) end_step(context.world, work, cauldron, tick);
    const bool stroked =
        does_something(cauldron.next) || cauldron.spoilt != 0 || cauldron.potion != cauldron.fluid_potion;
    if (cauldron.spoilt != 0) pour_away(work.brew);
    cauldron.spoilt = 0;
    if (!stroked && work.brew.fluid.state.asleep) return;
    cauldron.current = cauldron.next;
    cauldron.next = {};
    cauldron.fluid_potion = cauldron.potion;
    begin_step(context.data, solver, cauldron);
}

/// Advances the brew's simulated surface by one step, with the ladles as probes (bodies that touch it).
/// Ladles in or above the surface push it; ladles below it cause ripples when they leave.
void step_surface(MatchContext& context, Brew& brew, Cauldron& cauldron) {
    auto& surface = brew.surface;
    std::array<fluid::SurfaceProbe, players> probes;
    bool any = false;
    // A place of NaN marks a probe (a ladle) as absent.
    probes.fill({.place = vec2(std::numeric_limits<double>::quiet_NaN())});
    context.world.view<const Wizard, const Ladle>().each([&](const Wizard& wizard, const Ladle& ladle) {
        const vec3 at = ladle.place - cauldron.middle;
        probes[wizard.player] = {
            .place = {at.x, at.z}, .height = at.y, .radius = context.data.cauldron->ladle.radius};
        any = true;
    });
    if (!any && surface.asleep != 0) return;
    const auto step = fluid::advance(surface, brew.scratch, probes, surface_dt);
    for (std::size_t p = 0; p < players; ++p) {
        cauldron.surface_speed[p] = (step.probes[p].height - cauldron.height[p]) / surface_dt;
        cauldron.height[p] = step.probes[p].height;
    }
    write_surface(context.world, cauldron, surface);
}

std::unique_ptr<BrewWork> make_work(const MatchData& data) {
    auto basin = basin_of(data.arena.bowl->size, data.cauldron->filled);
    auto brew = make_brew(*data.cauldron, basin);
    THAUM_ASSERT(brew, brew.error().message);
    std::unique_ptr<BrewWork> work(
        new BrewWork{.brew = std::move(*brew), .basin = std::move(basin), .wet = {}});
    work->wet = wet_cells(work->brew, work->basin);
    work->step = Jobs::prepare([&brew_work = *work] {
        brew_work.report = fluid::advance(brew_work.brew.fluid, fluid_dt, &brew_work.team);
        brew_work.team.close();
        brew_work.figures = figures_of(brew_work);
    });
    work->help = Jobs::prepare([&team = work->team] { team.help(); });
    return work;
}

/// Waits for the running step, then frees the solver's memory.
void drop_work(BrewSolver& solver) {
    if (solver.work) wait_for_step(*solver.work);
    solver.work.reset();
}

}  // namespace

void spawn_cauldron(MatchContext& context, BrewSolver& solver) {
    drop_work(solver);
    if (!context.data.cauldron) return;
    const auto& bowl = *context.data.arena.bowl;
    Cauldron cauldron{.middle = bowl.centre};
    cauldron.middle.y += level_of(bowl.size, context.data.cauldron->filled);
    solver.bursts_seen = context.output.journal.read().count();
    context.world.create(cauldron);
}

void rebuild_brew(MatchContext& context, BrewSolver& solver) {
    drop_work(solver);
    if (!context.data.cauldron || !has_brew_state(context.world)) return;
    solver.work = make_work(context.data);
    auto& brew = solver.work->brew;
    auto& cauldron = context.world.single<Cauldron>();
    for (std::size_t s = 0; s < brew.contents.size(); ++s) {
        if (cauldron.contents[s] != no_ingredient)
            assign(brew, *context.data.cauldron, s, cauldron.contents[s]);
    }
    read_fluid(context.world, cauldron.newest, brew.fluid);
    brew.fluid.state.asleep = cauldron.step_running == 0;
    read_surface(context.world, cauldron, brew.surface);
    // Clears the haptic data of the brew, so that it is read again from the restored state.
    for (auto& model : context.output.models.write()) model.fluid = {};
    apply_changes(*context.data.cauldron, changes_of(context.data, cauldron), brew);
    if (cauldron.step_running != 0) begin_step(context.data, solver, cauldron);
}

void touch_brew(MatchContext& context, BrewSolver& solver) {
    if (solver.work || !context.data.cauldron) return;
    solver.work = make_work(context.data);
    make_brew_state(context.world, solver.work->brew);
}

bool add_stroke(Cauldron& cauldron, const Stroke& stroke) {
    auto& next = cauldron.next;
    for (std::uint32_t i = players; i < next.count && stroke.by != 0; ++i) {
        if (next.list[i].by != stroke.by) continue;
        next.list[i].place = stroke.place;
        next.list[i].impulse += stroke.impulse;
        return true;
    }
    const bool full = next.count == next.list.size();
    if (full && stroke.ingredient != no_ingredient) return false;
    if (full) {
        next.list.back().impulse += stroke.impulse;
    } else {
        next.list[next.count++] = stroke;
    }
    return true;
}

void add_ladle_stroke(Cauldron& cauldron, std::uint32_t player, vec3 place, vec3 impulse, double radius) {
    auto& stroke = cauldron.next.list[player];
    stroke.place = place;
    stroke.radius = radius;
    stroke.impulse += impulse;
}

double surface_at(const BrewWork* work, const Cauldron& cauldron, vec3 place) {
    if (work == nullptr) return cauldron.middle.y;
    const vec3 at = place - cauldron.middle;
    return cauldron.middle.y + fluid::height_at(work->brew.surface, {at.x, at.z});
}

double share_of_step(const Cauldron& cauldron, Tick tick) {
    const auto since = static_cast<double>(tick - cauldron.stepped);
    return std::min(1.0, since / static_cast<double>(fluid_period));
}

const ChangedBrew& changes_of(const MatchData& data, const Cauldron& cauldron) {
    static const ChangedBrew none;
    return cauldron.fluid_potion < data.recipes.size() ? data.recipes[cauldron.fluid_potion].fluid : none;
}

vec3 current_at(const ecs::World& world, const BrewWork* work, vec3 place, Tick tick) {
    if (work == nullptr) return vec3(0);
    const auto& cauldron = world.single<Cauldron>();
    const vec3 at = place - cauldron.middle;
    if (at.y > 0 || off_axis(at) > width_at(work->basin, at.y)) return vec3(0);
    const auto read = [&](std::size_t which) {
        const auto fields = fields_of(world, which, work->brew.fluid, field::Kernel::linear);
        return fields.velocity(at - work->brew.corner).value;
    };
    return glm::mix(read(cauldron.newest ^ 1U), read(cauldron.newest), share_of_step(cauldron, tick));
}

void add_brew_systems(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "brew's surface",
                  .period = surface_period,
                  .reads = world.mask<Wizard, Ladle>(),
                  .writes = world.mask<Cauldron, SurfaceSamples, resource::Brew>(),
                  .needs = world.mask<SurfaceSamples>(),
                  .run = [&context, &brew](ecs::World& w, Tick) {
                      const auto& work = brew.write().work;
                      if (work) step_surface(context, work->brew, w.single<Cauldron>());
                  }});
    schedule.add({.name = "brew",
                  .period = fluid_period,
                  .writes = world.mask<Cauldron, BrewSamples, resource::Brew>(),
                  .needs = world.mask<BrewSamples>(),
                  .run = [&context, &brew](ecs::World& w, Tick tick) {
                      auto& solver = brew.write();
                      if (solver.work) step_fluid(context, solver, w.single<Cauldron>(), tick);
                  }});
}

}  // namespace thaum::game::inline stations
