#include "game/brew/brew_pages.h"

#include <algorithm>

#include "core/assert.h"
#include "fluid/fields.h"

namespace thaum::game {
namespace {

/// Calls `visit` with every array of a state, in one fixed order.
template <class State, class Visit>
void each_array(State& state, Visit&& visit) {
    for (auto& component : state.velocity) visit(component);
    for (auto& substance : state.substances) visit(substance);
    visit(state.pressure);
    visit(state.projected);
}

std::size_t arrays_of(const fluid::Fluid& fluid) { return fluid.now.substances.size() + 5; }
std::size_t size_of(const fluid::Fluid& fluid) { return arrays_of(fluid) * fluid.lattice.size; }

template <class Page>
std::size_t pages_for(std::size_t samples) {
    constexpr std::size_t each = std::tuple_size_v<decltype(Page::samples)>;
    return (samples + each - 1) / each;
}

/// First sample of all pages, which form one contiguous array. They stay contiguous because a page entity has
/// no other component and is never removed alone.
template <class Page>
auto* first_sample(auto& world) {
    using Term =
        std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(world)>>, const Page, Page>;
    decltype(std::declval<Term&>().samples.data()) first = nullptr;
    std::size_t number = 0;
    world.template view<Term>().each([&](Term& page) {
        if (first == nullptr) first = page.samples.data();
        THAUM_ASSERT(page.samples.data() == first + number * page.samples.size(), "pages lie in a row");
        ++number;
    });
    return first;
}

}  // namespace

bool has_pages(const ecs::World& world) { return world.count<BrewPage>() > 0; }

void add_pages(ecs::World& world, const Brew& brew) {
    const auto fluid = pages_for<BrewPage>(2 * size_of(brew.fluid));
    const auto surface = pages_for<SurfacePage>(2 * brew.surface.height.size());
    world.reserve<BrewPage>(static_cast<std::uint32_t>(fluid));
    for (std::size_t i = 0; i < fluid; ++i) world.create(BrewPage{});
    for (std::size_t i = 0; i < surface; ++i) world.create(SurfacePage{});
}

void write_fluid(ecs::World& world, std::size_t which, const fluid::Fluid& fluid) {
    auto* to = first_sample<BrewPage>(world) + which * size_of(fluid);
    each_array(fluid.now, [&](const fluid::Samples& from) { to = std::copy(from.begin(), from.end(), to); });
}

void read_fluid(const ecs::World& world, std::size_t which, fluid::Fluid& fluid) {
    const auto* from = first_sample<BrewPage>(world) + which * size_of(fluid);
    each_array(fluid.now, [&](fluid::Samples& to) {
        std::copy_n(from, to.size(), to.begin());
        from += to.size();
    });
    fluid.now.pushed = false;
}

void write_surface(ecs::World& world, Cauldron& cauldron, const fluid::SpringSurface& surface) {
    auto* to = first_sample<SurfacePage>(world);
    to = std::copy(surface.height.begin(), surface.height.end(), to);
    std::copy(surface.velocity.begin(), surface.velocity.end(), to);
    cauldron.inside = surface.inside;
    cauldron.surface_asleep = surface.asleep;
}

void read_surface(const ecs::World& world, const Cauldron& cauldron, fluid::SpringSurface& surface) {
    const auto* from = first_sample<SurfacePage>(world);
    std::copy_n(from, surface.height.size(), surface.height.begin());
    std::copy_n(from + surface.height.size(), surface.velocity.size(), surface.velocity.begin());
    surface.inside = cauldron.inside;
    surface.asleep = cauldron.surface_asleep;
}

std::span<const float> brew_samples(const ecs::World& world, std::size_t which, const fluid::Fluid& fluid,
                                    std::size_t array) {
    const auto size = fluid.lattice.size;
    return {first_sample<BrewPage>(world) + which * size_of(fluid) + array * size, size};
}

BrewFields fields_of(const ecs::World& world, std::size_t which, const fluid::Fluid& fluid,
                     field::Kernel kernel) {
    const auto samples = [&](std::size_t array) { return brew_samples(world, which, fluid, array); };
    BrewFields fields;
    for (std::size_t axis = 0; axis < 3; ++axis)
        fields.velocity.component[axis] =
            fluid::grid_of(fluid.lattice, samples(axis), fluid.place(axis), kernel);
    for (std::size_t s = 0; s < fluid.now.substances.size(); ++s)
        fields.substances[s] = fluid::cell_grid(fluid.lattice, samples(3 + s), kernel);
    return fields;
}

}  // namespace thaum::game
