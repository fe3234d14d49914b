#include "game/cauldron/cauldron.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assert.h"
#include "game/brew/brew_pages.h"

namespace thaum::game {
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
    const auto& velocity = work.brew.fluid.now.velocity;
    double sum = 0;
    for (const auto cell : work.wet)
        sum += glm::length(vec3(velocity[0][cell], velocity[1][cell], velocity[2][cell]));
    return sum / static_cast<double>(work.wet.size());
}

BrewFigures figures_of(const BrewWork& work, double base_viscosity) {
    BrewFigures figures;
    const auto& fluid = work.brew.fluid;
    double viscosity = base_viscosity;
    std::optional<std::size_t> newest;
    for (std::size_t s = 0; s < work.brew.what.size(); ++s) {
        if (work.brew.what[s] == no_ingredient) continue;
        const double mean = mean_of(work, fluid.now.substances[s]);
        viscosity += fluid.settings.substances[s].viscosity * mean;
        figures.density += fluid.settings.substances[s].weight * mean;
        newest = s;
    }
    if (newest) figures.mixing = fluid::mixing(fluid, *newest);
    figures.viscosity = base_viscosity > 0 ? viscosity / base_viscosity : 1;
    figures.speed = mean_speed(work);
    return figures;
}

bool does_something(const Strokes& strokes) {
    return std::any_of(strokes.list.begin(), strokes.list.begin() + strokes.count,
                       [](const Stroke& s) { return s.ingredient != no_ingredient || s.impulse != vec3(0); });
}

void apply(const CauldronRules& rules, const Strokes& strokes, Brew& brew) {
    for (std::uint32_t i = 0; i < strokes.count; ++i) {
        const auto& stroke = strokes.list[i];
        if (stroke.ingredient != no_ingredient) {
            drop(brew, rules, stroke.ingredient, stroke.place, stroke.radius, stroke.amount);
        } else if (stroke.impulse != vec3(0)) {
            fluid::push(brew.fluid,
                        {stroke.place - brew.corner, stroke.radius, stroke.impulse / rules.density});
        }
    }
}

/// Starts the fluid step that takes the strokes in `given`.
void begin_step(MatchContext& context, Cauldron& cauldron) {
    auto& work = *context.brew;
    const auto& rules = *context.data.cauldron;
    apply(rules, cauldron.given, work.brew);
    cauldron.what = work.brew.what;
    cauldron.under_way = 1;
    work.step = context.jobs->run([&work, viscosity = rules.viscosity] {
        work.report = fluid::advance(work.brew.fluid, fluid_dt);
        work.figures = figures_of(work, viscosity);
    });
}

void end_step(MatchContext& context, Cauldron& cauldron, Tick tick) {
    auto& work = *context.brew;
    work.step.wait();
    cauldron.under_way = 0;
    cauldron.newest ^= 1U;
    cauldron.stepped = tick;
    cauldron.mixing = work.figures.mixing;
    cauldron.viscosity = work.figures.viscosity;
    cauldron.density = work.figures.density;
    cauldron.speed = work.figures.speed;
    write_fluid(context.world, cauldron.newest, work.brew.fluid);
}

/// Removes all ingredients. The flow of the pure brew is kept.
void pour_away(Brew& brew) {
    brew.what.fill(no_ingredient);
    for (auto& samples : brew.fluid.now.substances) std::fill(samples.begin(), samples.end(), 0.0F);
    std::fill(brew.fluid.settings.substances.begin(), brew.fluid.settings.substances.end(),
              fluid::Substance{});
}

void step_fluid(MatchContext& context, Cauldron& cauldron, Tick tick) {
    if (cauldron.under_way != 0) end_step(context, cauldron, tick);
    const bool stroked = does_something(cauldron.next) || cauldron.spoilt != 0;
    if (cauldron.spoilt != 0) pour_away(context.brew->brew);
    cauldron.spoilt = 0;
    if (!stroked && context.brew->brew.fluid.now.asleep) return;
    cauldron.given = cauldron.next;
    cauldron.next = {};
    begin_step(context, cauldron);
}

/// Steps the surface with the ladles as probes. Ladles in or above the surface push it; ladles below it make
/// ripples when they leave.
void step_surface(MatchContext& context, Cauldron& cauldron) {
    auto& sheet = context.brew->brew.sheet;
    std::array<fluid::SheetProbe, players> probes;
    bool any = false;
    probes.fill({.place = vec2(std::numeric_limits<double>::quiet_NaN())});  // absent probes
    context.world.view<const Wizard, const Ladle>().each([&](const Wizard& wizard, const Ladle& ladle) {
        const vec3 at = ladle.place - cauldron.middle;
        probes[wizard.player] = {
            .place = {at.x, at.z}, .height = at.y, .radius = context.data.cauldron->ladle.radius};
        any = true;
    });
    if (!any && sheet.asleep != 0) return;
    const auto step = fluid::advance(sheet, context.brew->brew.scratch, probes, surface_dt);
    for (std::size_t p = 0; p < players; ++p) {
        cauldron.rise[p] = (step.probes[p].height - cauldron.height[p]) / surface_dt;
        cauldron.height[p] = step.probes[p].height;
    }
    write_surface(context.world, cauldron, sheet);
}

std::unique_ptr<BrewWork> make_work(const MatchData& data) {
    auto basin = basin_of(data.arena.bowl->size, data.cauldron->filled);
    auto brew = make_brew(*data.cauldron, basin);
    THAUM_ASSERT(brew, brew.error().message);
    auto work =
        std::make_unique<BrewWork>(BrewWork{.brew = std::move(*brew), .basin = std::move(basin), .wet = {}});
    work->wet = wet_cells(work->brew, work->basin);
    return work;
}

}  // namespace

void spawn_cauldron(MatchContext& context) {
    if (context.brew) context.brew->step.wait();
    context.brew.reset();
    if (!context.data.cauldron) return;
    const auto& bowl = *context.data.arena.bowl;
    Cauldron cauldron{.middle = bowl.centre};
    cauldron.middle.y += level_of(bowl.size, context.data.cauldron->filled);
    context.bursts_seen = context.journal.count();
    context.world.create(cauldron);
}

void rebuild_brew(MatchContext& context) {
    if (context.brew) context.brew->step.wait();
    context.brew.reset();
    if (!context.data.cauldron || !has_pages(context.world)) return;
    context.brew = make_work(context.data);
    auto& brew = context.brew->brew;
    auto& cauldron = context.world.single<Cauldron>();
    for (std::size_t s = 0; s < brew.what.size(); ++s) {
        if (cauldron.what[s] != no_ingredient) assign(brew, *context.data.cauldron, s, cauldron.what[s]);
    }
    read_fluid(context.world, cauldron.newest, brew.fluid);
    brew.fluid.now.asleep = cauldron.under_way == 0;
    read_surface(context.world, cauldron, brew.sheet);
    // Haptic data is read again from the restored state.
    for (auto& model : context.models) model.fluid = {};
    if (cauldron.under_way != 0) begin_step(context, cauldron);
}

BrewWork* touched_brew(MatchContext& context) {
    if (context.brew || !context.data.cauldron) return context.brew.get();
    context.brew = make_work(context.data);
    add_pages(context.world, context.brew->brew);
    return context.brew.get();
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
    return cauldron.middle.y + fluid::height_at(work->brew.sheet, {at.x, at.z});
}

double share_of_step(const Cauldron& cauldron, Tick tick) {
    const auto since = static_cast<double>(tick - cauldron.stepped);
    return std::min(1.0, since / static_cast<double>(fluid_period));
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

void add_brew_systems(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "brew's surface",
                  .period = surface_period,
                  .reads = world.mask<Wizard, Ladle>(),
                  .writes = world.mask<Cauldron, SurfacePage>(),
                  .needs = world.mask<SurfacePage>(),
                  .run = [&context](ecs::World& w, Tick) {
                      if (context.brew) step_surface(context, w.single<Cauldron>());
                  }});
    schedule.add({.name = "brew",
                  .period = fluid_period,
                  .writes = world.mask<Cauldron, BrewPage>(),
                  .needs = world.mask<BrewPage>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      if (context.brew) step_fluid(context, w.single<Cauldron>(), tick);
                  }});
}

}  // namespace thaum::game
