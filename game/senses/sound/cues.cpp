#include "game/senses/sound/cues.h"

namespace thaum::game::inline senses {

Material material_of(Surface surface) {
    switch (surface) {
        case Surface::crate:
        case Surface::barrel:
        case Surface::table: return Material::wood;
        case Surface::bowl:
        case Surface::anchor: return Material::metal;
        case Surface::ball:
        case Surface::wizard: return Material::soft;
        default: return Material::stone;
    }
}

Cue step_on(Material material) {
    switch (material) {
        case Material::wood: return Cue::step_wood;
        case Material::metal: return Cue::step_metal;
        default: return Cue::step_stone;
    }
}

Cue hit_on(Material material) {
    switch (material) {
        case Material::wood: return Cue::hit_wood;
        case Material::metal: return Cue::hit_metal;
        case Material::soft: return Cue::hit_soft;
        case Material::stone: break;
    }
    return Cue::hit_stone;
}

}  // namespace thaum::game::inline senses
