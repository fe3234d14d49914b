// game/brew/brew_state.h: velocities, substances and surface of the brew as blobs in the World, where they
// are part of the match's state. Haptics and picture read the two newest fluid states there while a job
// computes the next one.
#pragma once
#include <span>

#include "ecs/world.h"
#include "field/field.h"
#include "game/brew/brew.h"
#include "game/components/cauldron.h"

namespace thaum::game::inline brew {

/// Makes the World's arrays (blobs) that hold the state of this brew. All samples are 0.
void make_brew_state(ecs::World& world, const Brew& brew);
bool has_brew_state(const ecs::World& world);

/// Copies the fluid to the World, or from there. The World stores two states of it; `which` is 0 or 1.
void write_fluid(ecs::World& world, std::size_t which, const fluid::Fluid& fluid);
void read_fluid(const ecs::World& world, std::size_t which, fluid::Fluid& fluid);
void write_surface(ecs::World& world, Cauldron& cauldron, const fluid::SpringSurface& surface);
void read_surface(const ecs::World& world, const Cauldron& cauldron, fluid::SpringSurface& surface);

/// One array of stored fluid state `which`: arrays 0 to 2 are the velocity components, 3 and above the
/// substances. The span stays valid until the World is cleared or restored.
std::span<const float> brew_samples(const ecs::World& world, std::size_t which, const fluid::Fluid& fluid,
                                    std::size_t array);

/// One state of the fluid as fields, in the frame of the fluid's box. The fields stay valid until the World
/// is cleared or restored.
struct BrewFields {
    field::StaggeredGrid velocity{};
    std::array<field::Grid, fluid::max_substances> substances{};
};
BrewFields fields_of(const ecs::World& world, std::size_t which, const fluid::Fluid& fluid,
                     field::Kernel kernel);

}  // namespace thaum::game::inline brew
