#include "game/brew/brew_state.h"

#include <algorithm>

#include "core/assert.h"
#include "fluid/fields.h"

namespace thaum::game::inline brew {
namespace {

/// Calls `visit` with every array of a fluid state, always in the same order.
template <class State, class Visit>
void each_array(State& state, Visit&& visit) {
    for (auto& component : state.velocity) visit(component);
    for (auto& substance : state.substances) visit(substance);
    visit(state.pressure);
    visit(state.projected);
}

std::size_t arrays_of(const fluid::Fluid& fluid) { return fluid.state.substances.size() + 5; }
std::size_t size_of(const fluid::Fluid& fluid) { return arrays_of(fluid) * fluid.lattice.size; }

}  // namespace

bool has_brew_state(const ecs::World& world) { return world.count<BrewSamples>() > 0; }

void make_brew_state(ecs::World& world, const Brew& brew) {
    world.resize<BrewSamples>(2 * size_of(brew.fluid));
    world.resize<SurfaceSamples>(2 * brew.surface.height.size());
}

void write_fluid(ecs::World& world, std::size_t which, const fluid::Fluid& fluid) {
    auto* to = world.blob<BrewSamples>().data() + which * size_of(fluid);
    each_array(fluid.state,
               [&](const fluid::Samples& from) { to = std::copy(from.begin(), from.end(), to); });
}

void read_fluid(const ecs::World& world, std::size_t which, fluid::Fluid& fluid) {
    const auto samples = world.blob<BrewSamples>();
    THAUM_ASSERT(samples.size() == 2 * size_of(fluid), "the World holds the state of another fluid");
    const auto* from = samples.data() + which * size_of(fluid);
    each_array(fluid.state, [&](fluid::Samples& to) {
        std::copy_n(from, to.size(), to.begin());
        from += to.size();
    });
    fluid.state.pushed = false;
}

void write_surface(ecs::World& world, Cauldron& cauldron, const fluid::SpringSurface& surface) {
    auto to = world.blob<SurfaceSamples>().begin();
    to = std::copy(surface.height.begin(), surface.height.end(), to);
    std::copy(surface.velocity.begin(), surface.velocity.end(), to);
    cauldron.inside = surface.inside;
    cauldron.surface_asleep = surface.asleep;
}

void read_surface(const ecs::World& world, const Cauldron& cauldron, fluid::SpringSurface& surface) {
    const auto from = world.blob<SurfaceSamples>().begin();
    std::copy_n(from, surface.height.size(), surface.height.begin());
    std::copy_n(from + static_cast<std::ptrdiff_t>(surface.height.size()), surface.velocity.size(),
                surface.velocity.begin());
    surface.inside = cauldron.inside;
    surface.asleep = cauldron.surface_asleep;
}

std::span<const float> brew_samples(const ecs::World& world, std::size_t which, const fluid::Fluid& fluid,
                                    std::size_t array) {
    const auto size = fluid.lattice.size;
    return world.blob<BrewSamples>().subspan(which * size_of(fluid) + array * size, size);
}

BrewFields fields_of(const ecs::World& world, std::size_t which, const fluid::Fluid& fluid,
                     field::Kernel kernel) {
    const auto samples = [&](std::size_t array) { return brew_samples(world, which, fluid, array); };
    BrewFields fields;
    for (std::size_t axis = 0; axis < 3; ++axis)
        fields.velocity.component[axis] =
            fluid::grid_of(fluid.lattice, samples(axis), fluid.place(axis), kernel);
    for (std::size_t s = 0; s < fluid.state.substances.size(); ++s)
        fields.substances[s] = fluid::cell_grid(fluid.lattice, samples(3 + s), kernel);
    return fields;
}

}  // namespace thaum::game::inline brew
