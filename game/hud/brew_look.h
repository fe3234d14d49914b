// game/hud/brew_look.h: how the cauldron's brew looks: its fluid as a glowing volume under a rippling skin, and over it, where
// somebody asks, arrows and streamlines of the flow; and the ladles, coloured by what they feel.
//
//     simulation                               pictures, any thread                         render thread
//     take_brew(brew, rules, state, picture)   show_brew(picture, overlay, look)            view.volume = &look.volume
//                                              add_brew(look, instances), add_ladle(...)
//
//     auto look = make_brew_look(renderer, brew_place(*arena.bowl, rules));   // once; needs the renderer's context
//     take_brew(brew, rules, ++state, picture);                               // after each step of the fluid
//     show_brew(picture, {.arrows = true}, look);                             // nothing where that state is shown already
//     add_brew(look, instances);                                              // before the view gets its span of them
//     add_ladle(look.meshes, {.bowl = ..., .grip = ..., .force_share = ...}, instances);
//     view.instances = instances;  view.volume = &look.volume;
//
// Pictures never feed back: nothing here changes a fluid or a sheet.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "game/arena/arena.h"
#include "game/hud/brew_picture.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace thaum::game {

/// Where a brew stands in the world.
struct BrewPlace {
    vec3 middle{};  ///< m, of the level surface: the origin of the brew's frame
    Basin basin{};
};
BrewPlace brew_place(const BowlPlace& bowl, const CauldronRules& rules);

/// What is shown of the flow; the brew is clearer then.
struct BrewOverlay {
    bool arrows = false;
    bool streamlines = false;
    bool operator==(const BrewOverlay&) const = default;
};

struct BrewMeshes {
    render::MeshId arrow{}, thread{};  ///< 1 m along -z
    render::MeshId rod{}, cup{};       ///< 1 m along -z; 1 m wide
};

/// All that is drawn of a brew. May be moved, not copied: `volume` looks into it.
struct BrewLook {
    BrewMeshes meshes;
    BrewPlace place;
    render::Volume volume;               ///< to be handed to views; of version 0 until something was shown
    std::vector<render::Instance> flow;  ///< arrows and streamlines
    std::uint64_t shown{};               ///< BrewPicture::state
    BrewOverlay overlay;

    std::vector<render::Texel> texels;
    std::vector<render::SkinVertex> skin;
    std::vector<std::uint32_t> skin_indices;
    std::vector<float> scratch;  ///< of the making

    BrewLook() = default;
    BrewLook(BrewLook&&) = default;
    BrewLook& operator=(BrewLook&&) = default;
};

BrewLook make_brew_look(render::Renderer& renderer, const BrewPlace& place);

/// Makes texels, skin and overlay anew where the picture's state or the overlay is another than before; true where it did.
bool show_brew(const BrewPicture& picture, const BrewOverlay& overlay, BrewLook& look);

void add_brew(const BrewLook& look, std::vector<render::Instance>& out);
void add_ladle(const BrewMeshes& meshes, const LadlePicture& ladle, std::vector<render::Instance>& out);

/// Green up to a third of what the device can give, yellow up to two thirds, red beyond.
fvec3 ladle_colour(double force_share);

}  // namespace thaum::game
