// game/scene/brew_look.h: the look of the cauldron's brew: a glowing volume under a moving surface mesh (the
// skin), and the ladles, coloured by the force on the hand. An overlay adds arrows and streamlines of the
// flow.
//
//     simulation                               any thread                          render thread
//     take_brew(brew, rules, state, picture)   show_brew(picture, overlay, look)   view.volume = &look.volume
//                                              add_brew(look, instances), add_ladle(...)
//
//     // Once; needs the renderer's context.
//     auto look = make_brew_look(renderer, brew_place(*arena.bowl, rules));
//     // After each fluid step.
//     take_brew(brew, rules, ++state, picture);
//     // For each frame. show_brew does nothing if the state is shown already.
//     show_brew(picture, {.arrows = true}, look);
//     add_brew(look, instances);
//     add_ladle(look.meshes, {.bowl = ..., .top = ..., .force_share = ...}, instances);
//     view.instances = instances;
//     view.volume = &look.volume;
//
// Drawing never changes a fluid or its surface.
#pragma once
#include <cstdint>
#include <vector>

#include "game/arena/arena.h"
#include "game/picture/brew_picture.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace thaum::game::inline scene {

/// Place of a brew in the world.
struct BrewPlace {
    vec3 middle{};  ///< middle of the level surface, the origin of the brew's frame (m)
    Basin basin{};
};
BrewPlace brew_place(const BowlPlace& bowl, const CauldronRules& rules);

/// Parts of the flow to show. While any of them is shown, the brew is drawn more transparent.
struct BrewOverlay {
    bool arrows = false;
    bool streamlines = false;
    bool operator==(const BrewOverlay&) const = default;
};

struct BrewMeshes {
    render::MeshId arrow{}, thread{};  ///< meshes of an arrow and of a streamline's piece, 1 m long along -z
    render::MeshId rod{}, cup{};       ///< rod of length 1 m along -z, and cup of radius 1 m
};

/// Everything drawn for a brew. It can be moved but not copied, because `volume` points into it.
struct BrewLook {
    BrewMeshes meshes;
    BrewPlace place;
    render::Volume volume;  ///< volume for the views; its version is 0 until a brew has been shown
    std::vector<render::Instance> flow;  ///< instances of arrows and streamlines
    std::uint64_t shown{};               ///< BrewPicture::state of the shown picture
    BrewOverlay overlay;

    std::vector<render::Texel> texels;
    std::vector<render::SkinVertex> skin;
    std::vector<std::uint32_t> skin_indices;
    std::vector<float> scratch;  ///< working memory of make_texels

    BrewLook() = default;
    BrewLook(BrewLook&&) = default;
    BrewLook& operator=(BrewLook&&) = default;
};

BrewLook make_brew_look(render::Renderer& renderer, const BrewPlace& place);

/// Refreshes texels, skin and overlay if the picture's state or the overlay has changed. Returns whether
/// anything was refreshed.
bool show_brew(const BrewPicture& picture, const BrewOverlay& overlay, BrewLook& look);

void add_brew(const BrewLook& look, std::vector<render::Instance>& out);
void add_ladle(const BrewMeshes& meshes, const LadlePicture& ladle, std::vector<render::Instance>& out);

/// Colour of a ladle: green up to a third of the device's peak force, yellow up to two thirds, red above.
fvec3 ladle_colour(double force_share);

}  // namespace thaum::game::inline scene
