// game/cauldron/brew_pages.h: the brew's samples in the World, where they are state. Its pages lie one after another, so that the
// newest two states of the fluid are read there, by hand and picture, while the next one is being computed elsewhere.
#pragma once
#include <span>

#include "ecs/world.h"
#include "field/field.h"
#include "game/cauldron/brew.h"
#include "game/components/cauldron.h"

namespace thaum::game {

/// Pages for this brew; to be called once, outside of any view.
void add_pages(ecs::World& world, const Brew& brew);
bool has_pages(const ecs::World& world);

/// State 0 or 1 of the fluid.
void write_fluid(ecs::World& world, std::size_t which, const fluid::Fluid& fluid);
void read_fluid(const ecs::World& world, std::size_t which, fluid::Fluid& fluid);
void write_surface(ecs::World& world, Cauldron& cauldron, const fluid::Sheet& sheet);
void read_surface(const ecs::World& world, const Cauldron& cauldron, fluid::Sheet& sheet);

/// One array of a state: 0 to 2 the velocity's components, from 3 on the substances. It holds as long as no page is added or removed.
std::span<const float> brew_samples(const ecs::World& world, std::size_t which, const fluid::Fluid& fluid,
                                    std::size_t array);

/// One state of the fluid as fields. Frame: the fluid's box. They hold as long as no page is added or removed.
struct BrewFields {
    field::StaggeredGrid velocity{};
    std::array<field::Grid, fluid::substances_most> substances{};
};
BrewFields fields_of(const ecs::World& world, std::size_t which, const fluid::Fluid& fluid,
                     field::Kernel kernel);

}  // namespace thaum::game
